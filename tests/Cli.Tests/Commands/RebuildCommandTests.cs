using System.Diagnostics;
using Harvester.Cli.Terminals;
using Harvester.Cli.Tests.Repetition;

namespace Harvester.Cli.Tests.Commands;

public sealed class RebuildCommandTests : IDisposable
{
    private const string Harvest =
        """{"folder":"street","command":["harvest","--frames","2","--size","64x48","--seed","5","--masks","--roads","@roads"]}""";

    private const string Export = """{"folder":"labels","command":["export","@street","--format","csv"]}""";

    private readonly TemporaryFolder _folder = new();

    public RebuildCommandTests() => File.WriteAllText(Roads, WritingCommand.Roads);

    private string Roads => _folder.PathOf("roads.csv");

    private string Made => _folder.PathOf("made");

    private string Lock => Path.Combine(Made, "dataset.lock");

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Dataset_is_rebuilt_from_its_lock_to_the_byte()
    {
        CliRun first = Rebuild(Recipe(Harvest, Export), "made");
        first.AssertDone();
        Assert.EndsWith($"{Made}: 2 folders, locked in dataset.lock\n", first.Out, StringComparison.Ordinal);

        CliRun again = Rebuild(Lock, "again");
        again.AssertDone();
        Assert.EndsWith(": 2 folders, 2 with the same bytes as the original\n", again.Out, StringComparison.Ordinal);
        Assert.Equal(FolderContent.Of(Made), FolderContent.Of(_folder.PathOf("again")));
        CliRun.Of("validate", Path.Combine(Made, "labels")).AssertDone();
    }

    [Fact]
    public void Lock_has_the_digest_of_the_listed_files()
    {
        Rebuild(Recipe(Harvest), "made").AssertDone();

        // By another program, from the documentation.
        var shell = new ProcessStartInfo("sh", ["-c", "find * -type f | LC_ALL=C sort | xargs sha256sum | sha256sum"])
        {
            WorkingDirectory = Path.Combine(Made, "street"),
            RedirectStandardOutput = true,
        };
        using Process process = Process.Start(shell)!;
        string digest = process.StandardOutput.ReadToEnd()[..64];
        Assert.Contains($"\"sha256\": \"{digest}\"", File.ReadAllText(Lock), StringComparison.Ordinal);
    }

    [Fact]
    public void Other_bytes_are_reported()
    {
        Rebuild(Recipe(Harvest, Export), "made").AssertDone();
        string changed = File.ReadAllText(Lock).Replace("\"5\"", "\"6\"", StringComparison.Ordinal);
        CliRun again = Rebuild(Write(changed), "again");
        Assert.Equal(ExitCode.BadData, again.ExitCode);
        Assert.Contains("is not the dataset of the recipe: street, labels has other bytes.", again.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void Another_input_is_refused_before_anything_is_written()
    {
        Rebuild(Recipe(Harvest), "made").AssertDone();
        File.AppendAllText(Roads, "\n");
        Rebuild(Lock, "again").AssertFailed(ExitCode.BadData, "this is not the input 'roads' of the recipe");
        Assert.False(Directory.Exists(_folder.PathOf("again")));
    }

    [Fact]
    public void Missing_input_is_named() =>
        CliRun
            .Of("rebuild", Recipe(Harvest), "--out", Made)
            .AssertFailed(ExitCode.Usage, "The recipe needs the input 'roads'. Add --input roads=FILE.");

    [Theory]
    [InlineData("""["drive"]""", "'drive' cannot be a step")]
    [InlineData("""["harvest","--out","x"]""", "--out is chosen when the dataset is rebuilt")]
    [InlineData("""["harvest","--out=x"]""", "--out is chosen when the dataset is rebuilt")]
    [InlineData("""["harvest","--overwrite"]""", "--overwrite is chosen")]
    [InlineData("""["harvest","--roads","/etc/passwd"]""", "'/etc/passwd' must be @NAME")]
    [InlineData("""["harvest","--roads=roads.csv"]""", "'roads.csv' must be @NAME")]
    [InlineData("""["harvest","--roads","@later"]""", "'@later' must be @NAME")]
    [InlineData("""["harvest","--rig","r.json"]""", "'r.json' must be @NAME")]
    [InlineData("""["relabel","@roads","--calibration","c.json"]""", "'c.json' must be @NAME")]
    [InlineData("""["export","@roads","--format","womd","--roads","r.csv"]""", "'r.csv' must be @NAME")]
    [InlineData("""["harvest","--log","logs"]""", "'logs' must be @NAME")]
    [InlineData("""["harvest","--props","p.json"]""", "'p.json' must be @NAME")]
    [InlineData("""["export","../other","--format","csv"]""", "'../other' must be @NAME")]
    [InlineData("""["harvest","--frames","many"]""", "many")]
    [InlineData("""["harvest","-q","--nonsense"]""", "Unrecognised argument '--nonsense'")]
    [InlineData("""["harvest","@words"]""", "'@words' must be @NAME")]
    [InlineData("""["harvest","--weather=@words"]""", "'@words' must be @NAME")]
    [InlineData("[]", "must have 1 to 200 words")]
    public void Command_that_reads_or_writes_elsewhere_is_refused(string command, string message)
    {
        string recipe = Recipe($$"""{"folder":"a","command":{{command}}}""");
        Rebuild(recipe, "made").AssertFailed(ExitCode.BadData, message);
        Assert.False(Directory.Exists(Made));
    }

    [Theory]
    [InlineData("{}", "version")]
    [InlineData("""{"version":2,"steps":[]}""", "version must be 1, not 2")]
    [InlineData("""{"version":1,"steps":[]}""", "steps is empty")]
    [InlineData("""{"version":1,"steps":[{"folder":"..","command":["harvest"]}]}""", "folder '..' must be")]
    [InlineData("""{"version":1,"steps":[{"folder":"a/b","command":["harvest"]}]}""", "folder 'a/b' must be")]
    [InlineData("""{"version":1,"inputs":[{"name":"A"}],"steps":[{"folder":"a","command":["harvest"]}]}""", "two entries")]
    [InlineData("""{"version":1,"steps":[{"folder":"a","command":["harvest"],"sha256":"0"}]}""", "not 64 hexadecimal digits")]
    public void Malformed_recipe_is_refused_in_one_line(string text, string message) =>
        CliRun.Of("rebuild", Write(text), "--out", Made).AssertFailed(ExitCode.BadData, message);

    [Fact]
    public void Check_writes_nothing()
    {
        CliRun checkedOnly = CliRun.Of("rebuild", Recipe(Harvest, Export), "--out", Made, "--input", $"roads={Roads}", "--check");
        checkedOnly.AssertDone();
        Assert.EndsWith(": 2 steps, 1 input, no problems\n", checkedOnly.Out, StringComparison.Ordinal);
        Assert.False(Directory.Exists(Made));
    }

    [Fact]
    public void Step_that_fails_is_named()
    {
        CliRun run = Rebuild(Recipe(Harvest, """{"folder":"b","command":["export","@street","--format","openlane-v2"]}"""), "made");
        Assert.NotEqual(ExitCode.Done, run.ExitCode);
        Assert.Contains("The step 'b' ended with exit code", run.Error, StringComparison.Ordinal);
        Assert.False(File.Exists(Lock));
    }

    private CliRun Rebuild(string recipe, string folder) =>
        CliRun.Of("rebuild", recipe, "--out", _folder.PathOf(folder), "--input", $"roads={Roads}");

    private string Recipe(params string[] steps) =>
        Write($$"""{"version":1,"inputs":[{"name":"roads"}],"steps":[{{string.Join(',', steps)}}]}""");

    private string Write(string text)
    {
        string path = _folder.PathOf("recipe.json");
        File.WriteAllText(path, text);
        return path;
    }
}
