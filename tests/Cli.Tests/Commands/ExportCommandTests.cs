namespace Harvester.Cli.Tests.Commands;

public sealed class ExportCommandTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public ExportCommandTests()
    {
        Directory.CreateDirectory(_folder.PathOf("session"));
        _folder.File("session/session.json", """{ "formatVersion": 1, "game": "simulation", "image": { "width": 80, "height": 60 }, "counters": { "captured": 0 } }""");
    }

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("kitti", "export.json")]
    [InlineData("coco", "annotations/instances_train.json")]
    [InlineData("yolo", "data.yaml")]
    [InlineData("csv", "objects.csv")]
    public void Export_writes_a_dataset(string format, string file)
    {
        CliRun run = CliRun.Of("export", _folder.PathOf("session"), "--format", format, "--out", _folder.PathOf("out"));

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Equal($"{_folder.PathOf("out")}: {format}, 0 frames, 0 objects\n", run.Out);
        Assert.True(File.Exists(_folder.PathOf("out/" + file)));
    }

    [Fact]
    public void Shards_are_merged()
    {
        foreach (string shard in (string[])["1/2", "2/2"])
        {
            CliRun run = CliRun.Of("export", _folder.PathOf("session"), "--format", "csv", "--out", _folder.PathOf("shards"), "--shard", shard);
            Assert.Contains($"shard {shard} of csv", run.Out, StringComparison.Ordinal);
        }

        CliRun merge = CliRun.Of("merge", _folder.PathOf("shards"), "--out", _folder.PathOf("out"));

        Assert.Equal(ExitCode.Done, merge.ExitCode);
        Assert.True(File.Exists(_folder.PathOf("out/export.json")));
    }

    [Theory]
    [InlineData("--format", "pascal", "--format takes one of kitti, ")]
    [InlineData("--split", "train", "--split takes names with shares")]
    [InlineData("--split", "train:0.5,val:0.1", "add up to 1")]
    [InlineData("--classes", "cars", "--classes takes some of car, ")]
    [InlineData("--min-visible", "2", "--min-visible takes a number from 0 to 1")]
    [InlineData("--shard", "3/2", "--shard takes a shard as 1/8")]
    public void Export_with_an_option_that_makes_no_sense_says_what_it_takes(string option, string value, string message)
    {
        string[] format = option == "--format" ? [] : ["--format", "csv"];

        CliRun.Of(["export", _folder.PathOf("session"), "--out", _folder.PathOf("out"), .. format, option, value]).AssertFailed(ExitCode.Usage, message);
    }

    [Fact]
    public void Export_of_no_session_is_an_input_error() =>
        CliRun.Of("export", "no-such-session", "--format", "csv", "--out", _folder.PathOf("out")).AssertFailed(ExitCode.InputOutput, "no-such-session");

    [Fact]
    public void Merge_of_a_folder_without_shards_is_an_error_of_the_data() =>
        CliRun.Of("merge", _folder.PathOf("session"), "--out", _folder.PathOf("out")).AssertFailed(ExitCode.BadData, "is a whole session, no shard of one");
}
