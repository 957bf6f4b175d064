using Harvester.Capture.Storage;

namespace Harvester.Capture.Tests.Storage;

public sealed class SessionContentTests : IDisposable
{
    private readonly SessionFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("{\"objects\":[{\"id\":3,\"class\":\"car\"},{\"id\":12,\"class\":\"bus\"}]}", 12)]
    [InlineData("{ \"objects\" : [ { \"class\" : \"car\", \"id\" : 3 } ] }", 3)]
    [InlineData("{\"objects\":[{\"id\":3,\"class\":\"car\",\"name\":\"\\\"id\\\":99,\\\"class\\\"\"}]}", 3)]
    [InlineData("{\"lanes\":{\"vehicles\":[{\"id\":50,\"class\":\"car\"}]},\"objects\":[{\"id\":3,\"class\":\"car\"}]}", 3)]
    [InlineData("{\"objects\":[]}", 0)]
    public void Greatest_object_id_is_that_of_the_labels(string line, int expected) => Assert.Equal(expected, ContentOf(line).MaxObjectId);

    [Theory]
    [InlineData("{\"objects\":[{\"id\":3,\"class\":\"car\"},{\"id\":4,#")]
    [InlineData("{\"objects\":[{\"id\":3},{\"id\":1e300}]}")]
    [InlineData("{\"objects\":[{\"id\":3},{\"id\":-9}]}")]
    public void Damaged_line_counts_as_far_as_it_can_be_read(string damaged)
    {
        SessionContent content = ContentOf(damaged, "{\"objects\":[{\"id\":2}]}");

        Assert.Equal(2, content.Frames);
        Assert.InRange(content.MaxObjectId, 3, 4);
    }

    private SessionContent ContentOf(params string[] lines)
    {
        Directory.CreateDirectory(_folder.Session);
        File.WriteAllText(Path.Combine(_folder.Session, "labels.jsonl"), string.Concat(lines.Select(line => line + "\n")));
        return SessionContent.Read(_folder.Session);
    }
}
