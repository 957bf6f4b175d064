using System.Text.Json;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Tests.Text;

public sealed class JsonTextTests
{
    [Fact]
    public void ToString_on_one_line_has_no_blanks()
    {
        JsonText json = new JsonText()
            .BeginObject()
            .Key("a")
            .Integer(1)
            .Key("b")
            .BeginArray()
            .Number(0.5, 2)
            .BeginArray()
            .EndArray()
            .Boolean(true)
            .EndArray()
            .Key("c")
            .BeginObject()
            .EndObject()
            .Key("d")
            .String(null)
            .EndObject();

        Assert.Equal("""{"a":1,"b":[0.5,[],true],"c":{},"d":null}""", json.ToString());
    }

    [Fact]
    public void ToString_indented_gives_members_lines_and_arrays_one_line()
    {
        JsonText json = new JsonText(indented: true)
            .BeginObject()
            .Key("a")
            .BeginObject()
            .Key("b")
            .Integer((long?)null)
            .EndObject()
            .Key("c")
            .BeginArray()
            .Integer(1)
            .Integer(2)
            .EndArray()
            .Key("d")
            .BeginObject()
            .EndObject()
            .EndObject();

        Assert.Equal("{\n  \"a\": {\n    \"b\": null\n  },\n  \"c\": [1, 2],\n  \"d\": {}\n}", json.ToString());
    }

    [Theory]
    [InlineData("plain")]
    [InlineData("quote \" backslash \\ slash /")]
    [InlineData("tab\tline\r\nbell\u0007")]
    [InlineData("Straße, 渋谷, 🚗")]
    public void String_is_read_back_by_another_reader(string value)
    {
        string text = new JsonText().BeginArray().String(value).EndArray().ToString();

        Assert.Equal(value, JsonDocument.Parse(text).RootElement[0].GetString());
    }
}
