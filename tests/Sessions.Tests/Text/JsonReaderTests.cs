using System.Text.Json;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Tests.Text;

public class JsonReaderTests
{
    [Fact]
    public void Fields_and_items_are_read_in_their_order()
    {
        var json = new JsonReader(" { \"a\" : [ 1, -2.5e1 ] , \"b\" : { \"c\" : true }, \"d\" : null } ");
        var read = new List<string>();

        json.Object(name =>
        {
            read.Add(name);
            switch (name)
            {
                case "a":
                    json.List(() => read.Add(FormattableString.Invariant($"{json.Number()}")));
                    break;
                case "b":
                    json.Object(inner => read.Add($"{inner} {json.Boolean()}"));
                    break;
                default:
                    json.Null();
                    break;
            }
        });
        json.End();

        Assert.Equal(["a", "1", "-25", "b", "c True", "d"], read);
    }

    [Theory]
    [InlineData("\"\\\"\\\\\\/\\b\\f\\n\\r\\t\\u00e9\"", "\"\\/\b\f\n\r\té")]
    [InlineData("\"\\ud83d\\ude97 name\"", "\ud83d\ude97 name")]
    [InlineData("\"\"", "")]
    public void Escapes_of_a_string_are_decoded(string text, string expected)
    {
        Assert.Equal(expected, new JsonReader(text).String());
        Assert.Equal(expected, JsonSerializer.Deserialize<string>(text));
    }

    [Fact]
    public void Skip_passes_over_any_value()
    {
        var json = new JsonReader("[{\"x\":[true,false,null,\"]\",1e3,{}],\"y\":{\"z\":[]}},7]");
        int items = 0;
        double last = 0;

        json.List(() =>
        {
            items++;
            if (items == 1)
            {
                json.Skip();
            }
            else
            {
                last = json.Number();
            }
        });
        json.End();

        Assert.Equal((2, 7), (items, last));
    }

    [Theory]
    [InlineData("", "invalid JSON at line 1, byte 1: the end of the text instead of a value")]
    [InlineData("{\"a\":1", "invalid JSON at line 1, byte 7: expected }")]
    [InlineData("{\"a\" 1}", "invalid JSON at line 1, byte 6: expected :")]
    [InlineData("{a:1}", "invalid JSON at line 1, byte 2: expected \"")]
    [InlineData("[1,]", "invalid JSON at line 1, byte 4: an invalid number")]
    [InlineData("[1e999]", "invalid number")]
    [InlineData("[NaN]", "invalid number")]
    [InlineData("[trve]", "invalid JSON at line 1, byte 2: an unknown word")]
    [InlineData("[\"\\x\"]", "unknown escape")]
    [InlineData("[\"\\u12\"]", "unknown escape")]
    [InlineData("[\"a\nb\"]", "control character")]
    [InlineData("[\"a", "byte 4: the end of the text in a string")]
    [InlineData("{\n\"é\": x}", "invalid JSON at line 2, byte 7: an invalid number")]
    [InlineData("[] []", "byte 4: more text after the value")]
    public void Text_that_is_not_JSON_is_refused_with_its_position(string text, string expected)
    {
        var json = new JsonReader(text);

        var error = Assert.Throws<FormatException>(() =>
        {
            json.Skip();
            json.End();
        });

        Assert.Contains(expected, error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Nesting_is_limited_instead_of_exhausting_the_stack()
    {
        new JsonReader(Nested(JsonReader.MaxDepth)).Skip();
        Assert.Throws<FormatException>(() => new JsonReader(Nested(JsonReader.MaxDepth + 1)).Skip());
        Assert.Throws<FormatException>(() => new JsonReader(new string('[', 1_000_000)).Skip());

        static string Nested(int depth) => new string('[', depth) + new string(']', depth);
    }
}
