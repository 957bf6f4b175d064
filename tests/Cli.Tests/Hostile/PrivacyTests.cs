using System.Diagnostics;
using System.Formats.Tar;
using System.IO.Compression;
using Harvester.Cli.Terminals;
using Harvester.Cli.Tests.Repetition;
using Harvester.Exports.Formats;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>What is written says nothing of the folder, the user and the machine: not in a name, a text, an archive or a picture.</summary>
public sealed class PrivacyTests : IClassFixture<PrivacyTests.Work>, IDisposable
{
    private const string Folder = "Telltale-9f3a";
    private const string User = "tellinguser";
    private const string Machine = "tellingmachine";

    private static readonly string[] Words = [Folder, User, Machine];

    private readonly Work _work;
    private readonly TemporaryFolder _folder = new();

    public PrivacyTests(Work work) => _work = work;

    public static TheoryData<string> Formats =>
        [.. DatasetFormats.All.Where(format => format.Program is null).Select(format => format.Name)];

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Harvested_session_has_no_trace_of_its_origin() => AssertNoTraces(_work.PathOf("session"));

    [Theory]
    [MemberData(nameof(Formats))]
    [Trait("Category", "Heavy")]
    public void Export_has_no_trace_of_its_origin(string format) =>
        AssertMade(
            $"export {_work.PathOf("session")} --format {format} --out OUT" + (DatasetFormats.Find(format)!.HasMap ? " --roads ROADS" : "")
        );

    [Theory]
    [InlineData("relabel SESSION --out OUT --range 60 --roads ROADS --spaces SESSION/scenes/spaces.csv")]
    [InlineData("merge PART-1 PART-2 --out OUT")]
    [InlineData("repair SESSION --out OUT")]
    [InlineData("report SESSION --out OUT/page.html")]
    [InlineData("report SESSION --out OUT/still.png --still 0")]
    [InlineData("drive --out OUT --traffic 0 --distance 3 --duration 2 --roads ROADS")]
    [InlineData("contact-sheet --out OUT/sheet.png --roads ROADS --size 64x48 --seconds 0 --at 0,-150")]
    [InlineData("roads import ROADS --out OUT/roads.csv.gz")]
    [InlineData("roads map ROADS --size 64 --out OUT/map.svg")]
    [InlineData("spaces gallery SESSION/scenes/spaces.csv --out OUT/gallery.html")]
    public void Output_has_no_trace_of_its_origin(string command) => AssertMade(command);

    [Fact]
    public async Task Unfinished_session_has_no_trace_of_its_command()
    {
        string made = _work.PathOf("unfinished");
        string mark = Path.Combine(made, ".harvester-unfinished");
        string seen = Directory.CreateDirectory(_work.PathOf("seen")).FullName;
        using var stop = new CancellationTokenSource();

        Task<CliRun> run = CliRun.BesideAsync(
            stop.Token,
            _work.Of("harvest --out OUT --roads ROADS --places 1 --frames 100000 --size 80x60 --no-report", made)
        );
        while (!run.IsCompleted && !(File.Exists(mark) && File.Exists(Path.Combine(made, "labels.jsonl"))))
        {
            await Task.Delay(1);
        }

        Assert.False(run.IsCompleted, run.IsCompleted ? (await run).Error : "");
        File.Copy(mark, Path.Combine(seen, "mark"));
        await stop.CancelAsync();
        await run;
        AssertNoTraces(seen);
        AssertNoTraces(made);
    }

    [Fact]
    public void Search_finds_words_in_names_archives_and_utf16()
    {
        File.WriteAllText(_folder.PathOf(User), "");
        File.WriteAllText(_folder.PathOf("text"), "in " + Folder, System.Text.Encoding.Unicode);
        using (ZipArchive zip = ZipFile.Open(_folder.PathOf("zip"), ZipArchiveMode.Create))
        using (var packed = new GZipStream(zip.CreateEntry("inner").Open(), CompressionLevel.Optimal))
        {
            packed.Write(System.Text.Encoding.UTF8.GetBytes(new string(' ', 999) + Machine));
        }

        Assert.Equal(3, Traces.Of(_folder.Path, Words).Count());
    }

    private static void AssertNoTraces(string folder)
    {
        Assert.NotEmpty(Directory.EnumerateFiles(folder, "*", SearchOption.AllDirectories));
        Assert.Empty(Traces.Of(folder, Words));
        foreach (string tar in Directory.EnumerateFiles(folder, "*.tar", SearchOption.AllDirectories))
        {
            using var reader = new TarReader(File.OpenRead(tar));
            while (reader.GetNextEntry() is { } entry)
            {
                Assert.Equal((0, 0, "", ""), (entry.Uid, entry.Gid, ((PosixTarEntry)entry).UserName, ((PosixTarEntry)entry).GroupName));
            }
        }
    }

    private void AssertMade(string command)
    {
        string made = _work.PathOf(Guid.NewGuid().ToString("N"));
        if (command.Contains("OUT/", StringComparison.Ordinal))
        {
            Directory.CreateDirectory(made);
        }

        CliRun.Of(_work.Of(command, made)).AssertDone();
        AssertNoTraces(made);
    }

    /// <summary>
    /// A folder with a telling name, and a session that a process harvested there whose environment has a telling user and machine.
    /// </summary>
    public sealed class Work : IDisposable
    {
        private const string Small =
            "--frames 2 --seed 2 --size 64x48 --masks --pedestrians 5 --semantics rays --flow --imu --occupancy --roads ROADS";

        private readonly TemporaryFolder _folder = new();

        public Work()
        {
            Directory.CreateDirectory(_folder.PathOf(Folder));
            File.WriteAllText(PathOf("roads.csv"), WritingCommand.Roads);
            Harvest("session", "");
            Harvest("part-1", " --shard 1/2");
            Harvest("part-2", " --shard 2/2");
        }

        public string PathOf(string name) => Path.Combine(_folder.PathOf(Folder), name);

        public string[] Of(string command, string to) =>
            [
                .. command
                    .Split(' ')
                    .Select(word =>
                        word.Replace("SESSION", PathOf("session"), StringComparison.Ordinal)
                            .Replace("PART", PathOf("part"), StringComparison.Ordinal)
                            .Replace("ROADS", PathOf("roads.csv"), StringComparison.Ordinal)
                            .Replace("OUT", to, StringComparison.Ordinal)
                    ),
            ];

        public void Dispose() => _folder.Dispose();

        private void Harvest(string name, string more)
        {
            string[] words = Of($"harvest --out OUT {Small}{more}", PathOf(name));
            var start = new ProcessStartInfo("dotnet", [Path.Combine(AppContext.BaseDirectory, "harvester.dll"), .. words])
            {
                WorkingDirectory = _folder.PathOf(Folder),
                RedirectStandardOutput = true,
            };
            Array.ForEach(["USER", "LOGNAME", "USERNAME"], variable => start.Environment[variable] = User);
            Array.ForEach(["COMPUTERNAME", "HOSTNAME"], variable => start.Environment[variable] = Machine);

            using Process harvest = Process.Start(start)!;
            harvest.StandardOutput.ReadToEnd();
            harvest.WaitForExit();
            Assert.Equal(ExitCode.Done, harvest.ExitCode);
        }
    }
}
