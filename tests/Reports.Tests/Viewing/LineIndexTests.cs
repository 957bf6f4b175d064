using System.Text;
using Harvester.Reports.Viewing;

namespace Harvester.Reports.Tests.Viewing;

public sealed class LineIndexTests : IDisposable
{
    private readonly string _path = Path.Combine(Path.GetTempPath(), $"harvester-test-{Guid.NewGuid():N}.jsonl");
    private readonly LineIndex _lines;

    public LineIndexTests() => _lines = new LineIndex(_path);

    public void Dispose()
    {
        _lines.Dispose();
        File.Delete(_path);
    }

    [Fact]
    public void Lines_are_read_in_any_order()
    {
        // Longer than the buffer of the index together, so that lines lie across its border.
        string[] lines = [.. Enumerable.Range(0, 3000).Select(number => $"{number} {new string('x', number % 1000)}")];
        File.WriteAllText(_path, string.Join('\n', lines) + "\n");

        ReadAll();

        Assert.Equal(3000, _lines.Count);
        foreach (int number in new[] { 2999, 0, 1500, 2097, 1 })
        {
            Assert.Equal(lines[number], Line(number));
        }
    }

    [Fact]
    public void Line_without_line_feed_counts_once_it_is_finished()
    {
        File.WriteAllText(_path, "first\nsec");
        ReadAll();
        Assert.Equal(1, _lines.Count);

        File.AppendAllText(_path, "ond\n");
        ReadAll();

        Assert.Equal(2, _lines.Count);
        Assert.Equal("second", Line(1));
    }

    [Fact]
    public void Missing_file_has_no_lines_until_it_appears()
    {
        Assert.False(_lines.Extend(long.MaxValue));
        Assert.Equal(0, _lines.Count);

        File.WriteAllText(_path, "first\n");
        ReadAll();

        Assert.Equal("first", Line(0));
    }

    [Fact]
    public void Index_is_extended_in_steps()
    {
        File.WriteAllText(_path, string.Concat(Enumerable.Repeat(new string('x', 99) + "\n", 30_000)));

        Assert.True(_lines.Extend(1));
        Assert.InRange(_lines.Count, 1, 29_999);
        ReadAll();

        Assert.Equal(30_000, _lines.Count);
    }

    [Fact]
    public void Number_outside_the_file_is_refused()
    {
        File.WriteAllText(_path, "first\n");
        ReadAll();

        Assert.Throws<ArgumentOutOfRangeException>(() => _lines.Read(1));
        Assert.Throws<ArgumentOutOfRangeException>(() => _lines.Read(-1));
    }

    [Fact]
    public void File_that_becomes_shorter_is_an_error()
    {
        File.WriteAllText(_path, "first\nsecond\n");
        ReadAll();
        File.WriteAllText(_path, "first\n");

        Assert.Contains("shorter", Assert.Throws<IOException>(ReadAll).Message, StringComparison.Ordinal);
        Assert.Throws<IOException>(() => _lines.Read(1));
    }

    private void ReadAll()
    {
        while (_lines.Extend(1 << 20)) { }
    }

    private string Line(int number) => Encoding.UTF8.GetString(_lines.Read(number));
}
