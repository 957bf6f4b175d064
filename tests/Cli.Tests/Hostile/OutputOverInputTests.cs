using Harvester.Cli.Terminals;
using Harvester.Cli.Tests.Commands;
using Harvester.Cli.Tests.Repetition;
using Harvester.TestSupport;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>No command overwrites its input with its output.</summary>
public sealed class OutputOverInputTests(SmallSession session) : IClassFixture<SmallSession>, IDisposable
{
    private const string Row = "prop_sign_road_01a,-949234773,sign,STOP,R1-1,0,-0.5,-0.04,3,0.5,-0.06,1.5,-y,measured,a test\n";
    private readonly HostileSession _hostile = new(session);

    public void Dispose() => _hostile.Dispose();

    [Fact]
    public void Gallery_does_not_replace_its_table()
    {
        string table = _hostile.PathOf("spaces.csv");
        File.WriteAllText(table, Row);

        Assert.Equal(ExitCode.Usage, HostileSession.Run("spaces", "gallery", table, "--out", table).ExitCode);

        Assert.Equal(Row, File.ReadAllText(table));
    }

    [PosixFact]
    public void Gallery_does_not_replace_its_table_through_a_link()
    {
        string table = _hostile.PathOf("spaces.csv");
        File.WriteAllText(table, Row);
        File.CreateSymbolicLink(_hostile.PathOf("link.csv"), table);

        Assert.Equal(ExitCode.Usage, HostileSession.Run("spaces", "gallery", _hostile.PathOf("link.csv"), "--out", table).ExitCode);

        Assert.Equal(Row, File.ReadAllText(table));
    }

    [Theory]
    [InlineData("photos.csv")]
    [InlineData("photos/a.png")]
    [InlineData("prop_sign_road_01a.png")]
    public void Gallery_does_not_replace_its_photographs(string name)
    {
        Directory.CreateDirectory(_hostile.PathOf("survey/photos"));
        string table = _hostile.PathOf("survey/spaces.csv");
        File.WriteAllText(table, Row);
        string photo = _hostile.PathOf("survey/" + name);
        File.WriteAllText(photo, "a photograph");

        Assert.Equal(ExitCode.Usage, HostileSession.Run("spaces", "gallery", table, "--out", photo).ExitCode);

        Assert.Equal("a photograph", File.ReadAllText(photo));
    }

    [Theory]
    [InlineData("frames/00000001.png")]
    [InlineData("masks/00000000.png")]
    [InlineData("other/picture.png")]
    public void Still_does_not_replace_a_picture_of_the_session(string name)
    {
        if (name.StartsWith("other", StringComparison.Ordinal))
        {
            Directory.CreateDirectory(_hostile.In("other"));
            File.Move(_hostile.In("frames/00000001.png"), _hostile.In(name));
            _hostile.Replace("labels.jsonl", "frames/00000001.png", name);
        }

        byte[] before = File.ReadAllBytes(_hostile.In(name));

        Assert.Equal(ExitCode.Usage, HostileSession.Run("report", _hostile.Folder, "--still", "0", "--out", _hostile.In(name)).ExitCode);

        Assert.Equal(before, File.ReadAllBytes(_hostile.In(name)));
    }

    [Theory]
    [InlineData("roads", "nodes", "ROADS", "--out", "ROADS")]
    [InlineData("roads", "import", "ROADS", "--out", "ROADS")]
    [InlineData("contact-sheet", "--size", "64x48", "--roads", "ROADS", "--out", "ROADS")]
    [InlineData("contact-sheet", "--size", "64x48", "--roads", "ROADS", "--list", "LIST", "--out", "LIST")]
    [InlineData("contact-sheet", "--size", "64x48", "--roads", "ROADS", "--list", "LIST", "--out", "a/../LIST")]
    public void Output_does_not_replace_a_file_that_is_read(params string[] command)
    {
        string roads = _hostile.PathOf("roads.csv");
        string list = _hostile.PathOf("places.csv");
        File.WriteAllText(roads, WritingCommand.Roads);
        File.WriteAllText(list, "North,0,150\n");

        CliRun run = HostileSession.Run([
            .. command.Select(word =>
                word.Replace("a/../LIST", _hostile.PathOf("a/../places.csv"), StringComparison.Ordinal)
                    .Replace("LIST", list, StringComparison.Ordinal)
                    .Replace("ROADS", roads, StringComparison.Ordinal)
            ),
        ]);

        run.AssertFailed(ExitCode.Usage, "would replace an input");
        Assert.Equal((WritingCommand.Roads, "North,0,150\n"), (File.ReadAllText(roads), File.ReadAllText(list)));
    }

    [Fact]
    public void Still_may_lie_in_the_folder_of_the_session() =>
        Assert.Equal(
            ExitCode.Done,
            HostileSession.Run("report", _hostile.Folder, "--still", "0", "--out", _hostile.In("still.png")).ExitCode
        );
}
