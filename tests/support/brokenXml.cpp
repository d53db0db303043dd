#include "support/brokenXml.h"

#include <stdexcept>

namespace gr2to::test
{
std::string completeXml()
{
    return R"(<?xml version="1.0" encoding="UTF-8"?>
<topological_map version="1.0" frame="map" resolution="0.05" source="office.yaml">
  <places>
    <place id="3" kind="room" area="22.23">
      <words>
        <word>Sam's office</word>
        <word>&lt;desk&gt; &amp; chair</word>
      </words>
      <center x="1" y="2" z="0" />
      <boundary>0,0 4,0 4,3.5</boundary>
      <walls>
        <wall id="12" real="1">
          <position x="2" y="0" z="1.25" cov="0.5 0.125 0 0.5 0 1" />
          <normal x="0" y="-1" z="0" cov="1 0 0 0 0 0" />
          <size length="4" height="2.5" cov="0.5 0.25 1" />
          <curvature length="0.1" height="0" />
        </wall>
        <wall id="13" real="0">
          <position x="4" y="1.75" z="0" />
          <normal x="1" y="0" z="0" />
          <size length="3.5" />
          <curvature length="0" height="0" />
        </wall>
      </walls>
      <views>
        <view image="views/3_0.png" time="1700000000.25">
          <position x="1" y="2" z="1.5" cov="0.25 0 0 0.25 0 0.25" />
          <aperture x="1.5" y="1" />
        </view>
      </views>
    </place>
    <place id="5" kind="corridor" area="9">
      <words />
      <center x="5" y="2" z="0" />
      <boundary />
      <walls />
      <views />
    </place>
  </places>
  <connections>
    <connection id="7" from="3" to="5">
      <words>
        <word>blue door</word>
      </words>
      <doorway real="1" state="open">
        <position x="4" y="1" z="1" cov="0.5 0 0 0.5 0 0.5" />
        <size length="0.92" height="2.05" />
        <view image="views/7.png">
          <position x="3" y="1" z="1.5" />
          <aperture x="1" y="1" />
        </view>
      </doorway>
    </connection>
    <connection id="8" from="3" to="5">
      <words />
      <doorway real="0" state="unknown">
        <position x="4" y="3" z="0" />
        <size length="1.5" />
      </doorway>
    </connection>
  </connections>
</topological_map>
)";
}

std::string BrokenXml::text() const
{
    std::string text = completeXml();
    const auto at = text.find(original);
    if (at == std::string::npos) throw std::logic_error("completeXml() has no " + original);
    return text.replace(at, original.size(), replacement);
}

std::vector<BrokenXml> foreignXml()
{
    return {
        {"version=\"1.0\" frame", "version=\"1.1\" frame",
         "topological_map: attribute version = '1.1' must be 1.0, the version that can be read"},
        {"frame=\"map\" ", "", "topological_map: attribute frame is missing"},
        {"resolution=\"0.05\"", "resolution=\"5 cm\"",
         "topological_map: attribute resolution = '5 cm' is not a finite number"},
        {"<connections>", "<rooms /><connections>",
         "rooms: the element is unknown; topological_map has places, connections"},
        {"<place id=\"3\"", "<place id=\"0\"",
         "places/place[id=0]: attribute id = '0' must be a whole number from 1 to 65535"},
        {"<place id=\"3\"", "<place id=\"65536\"",
         "places/place[id=65536]: attribute id = '65536' must be a whole number from 1 to 65535"},
        {"<place id=\"3\"", "<place id=\"three\"",
         "places/place[1]: attribute id = 'three' must be a whole number from 1 to 65535"},
        {"<place id=\"5\"", "<place id=\"3\"",
         "places/place[id=3]: id = 3 is taken; the ids of places must be unique"},
        {"kind=\"room\"", "kind=\"lift\"",
         "places/place[id=3]: attribute kind = 'lift' must be one of room, corridor"},
        {"area=\"22.23\"", "area=\"22.23\" colour=\"red\"",
         "places/place[id=3]: attribute 'colour' is unknown; it has id, kind, area"},
        {"<word>Sam's office</word>", "<name>Sam</name>",
         "places/place[id=3]/words/name[1]: the element is unknown; there may be word only"},
        {"<word>Sam's office</word>", "Sam's office",
         "places/place[id=3]/words: has the text '?        Sam's office?        '; there may be elements "
         "only"},
        {"Sam's office", "<b>Sam</b>",
         "places/place[id=3]/words/word[1]/b: the element is unknown; there may be text only"},
        {"<word>Sam's", "<word lang=\"en\">Sam's",
         "places/place[id=3]/words/word[1]: attribute 'lang' is unknown; it has no attributes"},
        {"<words>", "<words lang=\"en\">",
         "places/place[id=3]/words: attribute 'lang' is unknown; it has no attributes"},
        {"<center x=\"1\" y=\"2\" z=\"0\" />", "", "places/place[id=3]: element center is missing"},
        {"<center x=\"1\" y=\"2\" z=\"0\" />", "<center x=\"1\" y=\"2\" />",
         "places/place[id=3]/center: attribute z is missing"},
        {"<center x=\"1\"", "<center x=\"\"",
         "places/place[id=3]/center: attribute x = '' is not a finite number"},
        {"<center x=\"1\"", "<center x=\"INF\"",
         "places/place[id=3]/center: attribute x = 'INF' is not a finite number"},
        {"<center x=\"1\"", "<center x=\"1e999\"",
         "places/place[id=3]/center: attribute x = '1e999' is not a finite number"},
        {"<center x=\"1\"", "<center x=\"0x1p3\"",
         "places/place[id=3]/center: attribute x = '0x1p3' is not a finite number"},
        {"<center x=\"1\"", "<center x=\"1,5\"",
         "places/place[id=3]/center: attribute x = '1,5' is not a finite number"},
        {"<boundary />", "<boundary /><boundary />", "places/place[id=5]: element boundary is there 2 times"},
        {"<boundary />\n      <walls />", "<walls /><boundary />",
         "places/place[id=5]: its elements must come in the order words, center, boundary, walls, views"},
        {"4,0 4,3.5", "4 0 4,3.5",
         "places/place[id=3]/boundary: '4' is not a vertex; write x,y in metres, blanks between vertices"},
        {"4,0 4,3.5", "4,0,0 4,3.5",
         "places/place[id=3]/boundary: '4,0,0' is not a vertex; write x,y in metres, blanks between "
         "vertices"},
        {"<position x=\"4\" y=\"1.75\"", "<position y=\"1.75\"",
         "places/place[id=3]/walls/wall[2]/position: attribute x is missing"},
        {"<wall id=\"13\"", "<wall id=\"12\"",
         "places/place[id=3]/walls/wall[2]: id = 12 is taken; the ids of walls must be unique in the map"},
        {"real=\"1\"", "real=\"yes\"",
         "places/place[id=3]/walls/wall[1]: attribute real = 'yes' must be one of 0, 1"},
        {"0.5 0.125 0 0.5 0 1", "0.5 0.125 0 0.5 0",
         "places/place[id=3]/walls/wall[1]/position: attribute cov has 5 numbers; it must have 6"},
        {"0.5 0.125 0 0.5 0 1", "",
         "places/place[id=3]/walls/wall[1]/position: attribute cov has 0 numbers; it must have 6"},
        {"0.5 0.25 1", "0.5 nan 1",
         "places/place[id=3]/walls/wall[1]/size: attribute cov has 'nan', not a finite number"},
        {"<curvature length=\"0.1\" height=\"0\" />", "<curvature length=\"0.1\" />",
         "places/place[id=3]/walls/wall[1]/curvature: attribute height is missing"},
        {"image=\"views/3_0.png\" ", "", "places/place[id=3]/views/view[1]: attribute image is missing"},
        {"time=\"1700000000.25\"", "time=\"yesterday\"",
         "places/place[id=3]/views/view[1]: attribute time = 'yesterday' is not a finite number"},
        {"<aperture x=\"1.5\" y=\"1\" />", "<aperture x=\"1.5\" y=\"1\"><z /></aperture>",
         "places/place[id=3]/views/view[1]/aperture/z: the element is unknown; aperture has no elements"},
        {"<connection id=\"8\"", "<connection id=\"7\"",
         "connections/connection[id=7]: id = 7 is taken; the ids of connections must be unique"},
        {"<connection id=\"7\" from=\"3\"", "<connection id=\"7\" from=\"4\"",
         "connections/connection[id=7]: attribute from: there is no place with id 4"},
        {"<connection id=\"8\" from=\"3\" to=\"5\"", "<connection id=\"8\" from=\"3\" to=\"6\"",
         "connections/connection[id=8]: attribute to: there is no place with id 6"},
        {"state=\"open\"", "state=\"ajar\"",
         "connections/connection[id=7]/doorway: attribute state = 'ajar' must be one of open, closed, "
         "unknown"},
        {"<size length=\"0.92\"", "<size",
         "connections/connection[id=7]/doorway/size: attribute length is missing"},
        {"<view image=\"views/7.png\">", "<view image=\"views/7.png\" time=\"1e\">",
         "connections/connection[id=7]/doorway/view: attribute time = '1e' is not a finite number"},
    };
}

std::vector<BrokenXml> malformedXml()
{
    const std::string start = "is not well-formed XML: ";
    return {
        {completeXml(), " \n", "line 2 (byte 2) " + start + "there is no root element"},
        {completeXml(), "<!-- nothing -->", "line 1 (byte 16) " + start + "there is no root element"},
        {"</topological_map>", "", "line 62 (byte 1922) " + start + "Start-end tags mismatch"},
        {"</topological_map>", "</topological_map>more",
         "line 62 (byte 1940) " + start + "there is text outside the root element"},
        {"</topological_map>", "</topological_map><topological_map/>",
         "line 62 (byte 1941) " + start + "there is a second root element"},
        {"Sam's", "Sam\xE9s",
         "line 6 (byte 208) " + start + "it is not UTF-8 text without control characters"},
        {"Sam's", std::string("Sam\0s", 5),
         "line 6 (byte 208) " + start + "it is not UTF-8 text without control characters"},
        {"Sam's", "Sam&apos s",
         "line 6 (byte 208) " + start +
             "'&apos s offi' is not a reference to a character; a plain & is written &amp;"},
        {"Sam's", "Sam&nbsp;s",
         "line 6 (byte 208) " + start +
             "'&nbsp;' is not a reference to a character; a plain & is written &amp;"},
        {"Sam's", "Sam&#0;s",
         "line 6 (byte 208) " + start +
             "'&#0;' is not a reference to a character; a plain & is written &amp;"},
        {"Sam's", "Sam&#xD800;s",
         "line 6 (byte 208) " + start +
             "'&#xD800;' is not a reference to a character; a plain & is written &amp;"},
        {"encoding=\"UTF-8\"", "encoding=\"ISO-8859-1\"",
         "line 1 (byte 2) " + start + "the encoding must be UTF-8; convert the file"},
        {"<topological_map", "<!DOCTYPE a [<!ENTITY b \"bb\">]><topological_map",
         "line 2 (byte 49) " + start + "a document type declaration is not supported; remove it"},
        {"kind=\"room\"", "kind=\"room\" kind=\"room\"", "places/place[id=3]: attribute kind is there twice"},
    };
}
}  // namespace gr2to::test
