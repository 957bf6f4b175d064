using System.Text;
using System.Text.Json;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Sessions.Tests.Reading.Json;

public sealed class JsonListReaderTests : IDisposable
{
    private readonly string _path = Path.GetTempFileName();

    public void Dispose() => File.Delete(_path);

    [Fact]
    public void Read_gives_the_elements_of_all_lists_with_their_lines()
    {
        const string text = """
            {"info": {"list": [7]}, "first": [
            1, {"a": [2,
            3]},
            "x"], "empty": [], "number": 5,
            "second":
              [null,
               [4]]}
            """;

        Assert.Equal(["2 first 1", "2 first {\"a\": [2,\n3]}", "4 first \"x\"", "6 second null", "7 second [4]"], Elements(text));
    }

    [Fact]
    public void Read_of_elements_longer_than_any_buffer_gives_them_whole()
    {
        // Elements of many lengths, so that the ends of the buffer fall everywhere; the last has a million characters.
        string[] words = [.. Enumerable.Range(0, 300).Select(i => new string((char)('a' + (i % 26)), i * 7)), new string('z', 1_000_000)];
        string text = "{\"list\":[\n" + string.Join(",\n", words.Select(word => $"\"{word}\"")) + "\n]}";

        Assert.Equal(words.Select((word, i) => $"{i + 2} list \"{word}\""), Elements(text));
    }

    [Theory]
    [InlineData("{\"list\":[1,2", 0)]
    [InlineData("{\"list\":[1,\n2}", 1)]
    [InlineData("", 0)]
    public void Read_of_invalid_json_throws_with_the_line(string text, long line) =>
        Assert.Equal(line, Assert.ThrowsAny<JsonException>(() => Elements(text)).LineNumber);

    private List<string> Elements(string text)
    {
        File.WriteAllText(_path, text.ReplaceLineEndings("\n"), new UTF8Encoding(false));
        using var reader = new JsonListReader(_path);
        var elements = new List<string>();
        while (reader.Read())
        {
            elements.Add($"{reader.Line} {reader.List} {reader.Element.GetRawText()}");
        }

        return elements;
    }
}
