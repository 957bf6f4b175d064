using Harvester.Cli.Terminals;
using Harvester.TestSupport;

namespace Harvester.Cli.Tests.Commands;

public sealed class RepairCommandTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    private string Session => _folder.PathOf("session");

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Repair_recovers_whole_frames_and_lists_what_was_lost()
    {
        Harvest();
        File.Delete(Path.Combine(Session, "frames", "00000001.png"));

        CliRun run = CliRun.Of("repair", Session);

        Assert.Equal(ExitCode.BadData, run.ExitCode);
        Assert.Equal(
            ["labels.jsonl, line 2: image 'frames/00000001.png' is missing.", $"{Session}-repaired: 2 frames recovered, 1 lost", ""],
            run.Out.Split('\n')
        );
        Assert.Equal(ExitCode.Done, CliRun.Of("validate", Session + "-repaired").ExitCode);
    }

    [Fact]
    public void Repair_of_an_undamaged_session_succeeds()
    {
        Harvest();

        CliRun run = CliRun.Of("repair", Session, "--out", _folder.PathOf("made"));

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Equal($"{_folder.PathOf("made")}: 3 frames recovered, 0 lost\n", run.Out);
    }

    [Fact]
    public void Repaired_session_can_be_repaired_again()
    {
        Harvest();
        CliRun.Of("repair", Session, "--out", _folder.PathOf("made")).AssertDone();

        CliRun.Of("repair", _folder.PathOf("made"), "--out", _folder.PathOf("again")).AssertDone();

        Assert.Equal(File.ReadAllText(_folder.PathOf("made/session.json")), File.ReadAllText(_folder.PathOf("again/session.json")));
    }

    [Fact]
    public void Repair_of_a_session_in_place_is_refused()
    {
        Harvest();

        CliRun run = CliRun.Of("repair", Session, "--out", Session + "/");

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Contains("Name another folder", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void Refused_repair_leaves_no_output()
    {
        Harvest();
        File.Delete(Path.Combine(Session, "session.json"));
        Directory.Delete(Path.Combine(Session, "frames"), recursive: true);

        CliRun.Of("repair", Session).AssertFailed(ExitCode.BadData, "nothing can be recovered");

        Assert.False(Directory.Exists(Session + "-repaired"));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Header_that_is_not_UTF_8_is_made_again()
    {
        Harvest();
        string path = Path.Combine(Session, "session.json");
        byte[] bytes = File.ReadAllBytes(path);
        File.Delete(path);
        int at = bytes.AsSpan().IndexOf("harvester "u8);
        File.WriteAllBytes(path, [.. bytes[..at], 0xFF, .. bytes[at..]]);

        CliRun run = CliRun.Of("repair", Session);

        Assert.Equal((ExitCode.BadData, ""), (run.ExitCode, run.Error));
        Assert.Contains(
            "session.json: it is damaged (it is not UTF-8); game, options and lens are lost.",
            run.Out,
            StringComparison.Ordinal
        );
    }

    /// <summary>Bits, missing and inserted bytes, and missing ends, spread over the file.</summary>
    [Theory]
    [Trait("Category", "Heavy")]
    [InlineData("manifest.jsonl")]
    [InlineData("session.json")]
    [InlineData("labels.jsonl")]
    [InlineData("scenes/00000001.json")]
    public void Repair_of_a_damaged_file_succeeds_or_leaves_no_output(string file)
    {
        int places = ProofSize.Of(inCi: 8, full: 60);
        Harvest();
        string path = Path.Combine(Session, file);
        byte[] bytes = File.ReadAllBytes(path);
        File.Delete(path);
        for (int place = 0; place < places; place++)
        {
            int at = place * bytes.Length / places;
            byte[] flipped = [.. bytes];
            flipped[at] ^= (byte)(1 << (place % 8));
            byte[][] damaged = [flipped, bytes[..at], [.. bytes[..at], .. bytes[(at + 1)..]], [.. bytes[..at], 0xFF, .. bytes[at..]]];
            foreach (byte[] content in damaged)
            {
                File.WriteAllBytes(path, content);

                CliRun run = CliRun.Of("repair", Session);

                Assert.InRange(run.ExitCode, ExitCode.Done, ExitCode.BadData);
                Assert.Equal(run.Error.Length == 0, Directory.Exists(Session + "-repaired"));
                Assert.True(run.Error.Length > 0 || CliRun.Of("validate", Session + "-repaired", "--quick").ExitCode == ExitCode.Done);
                if (run.Error.Length == 0)
                {
                    Directory.Delete(Session + "-repaired", recursive: true);
                }
            }
        }
    }

    [Fact]
    public void Quick_validate_finds_damage_by_the_manifest()
    {
        Harvest();
        string image = Path.Combine(Session, "frames", "00000001.png");
        byte[] bytes = File.ReadAllBytes(image);
        bytes[bytes.Length / 2] ^= 1;
        File.WriteAllBytes(image, bytes);

        CliRun run = CliRun.Of("validate", Session, "--quick");

        Assert.Equal(ExitCode.BadData, run.ExitCode);
        Assert.StartsWith(
            "labels.jsonl, line 2: image 'frames/00000001.png' is damaged: its SHA-256 differs",
            run.Out,
            StringComparison.Ordinal
        );
    }

    private void Harvest() => SharedHarvest.CopyTo(Session, "--frames", "3", "--seed", "5", "--size", "80x60", "--no-report");
}
