using Harvester.Cli.Terminals;
using Harvester.Cli.Tests.Commands;
using Harvester.Cli.Tests.Repetition;

namespace Harvester.Cli.Tests.Durability;

/// <summary>What is on the disk before what: the order of docs/dataset-format.md, "What is durable when".</summary>
public sealed class DurableOrderTests(SmallSession session) : IClassFixture<SmallSession>, IDisposable
{
    private readonly TemporaryFolder _folder = new();

    // Folders are recorded if they are below the watched one.
    private string Out => _folder.PathOf("root/in/out");

    public void Dispose() => _folder.Dispose();

    [CompilerFact]
    [Trait("Category", "Heavy")]
    public void Export_is_on_the_disk_before_export_json_is_there()
    {
        RecordedOperations operations = Record("export", session.Folder, "--format", "yolo", "--out", Out);

        foreach (string file in (string[])["in/out/images/train/00000000.png", "in/out/labels/train/00000001.txt"])
        {
            operations.AssertOrder(
                $"open {file}",
                "write in/out/.export/journal-1-of-1.jsonl",
                "flush in/out/.export/journal-1-of-1.jsonl"
            );
        }

        foreach (string folder in (string[])["in", "in/out", "in/out/images", "in/out/images/train", "in/out/labels/train"])
        {
            operations.AssertOrder($"open {folder}", "write in/out/.export/journal-1-of-1.jsonl");
        }

        operations.AssertOrder(
            "flush in/out/.export/plan.json.*.partial",
            "rename in/out/.export/plan.json",
            "open in/out/.export",
            "create in/out/.export/journal-1-of-1.jsonl",
            "open in/out/.export",
            "write in/out/.export/journal-1-of-1.jsonl",
            "rename in/out/data.yaml",
            "open in/out/data.yaml",
            "rename in/out/manifest.jsonl",
            "open in/out/manifest.jsonl",
            "open in/out",
            "rename in/out/export.json",
            "open in/out/export.json",
            "open in/out",
            "delete in/out/.export/plan.json",
            "rmdir in/out/.export",
            "open in/out"
        );
    }

    [CompilerFact]
    [Trait("Category", "Heavy")]
    public void Merged_export_is_on_the_disk_before_export_json_is_there()
    {
        string[] shards = Shards();

        RecordedOperations operations = Record(["merge", .. shards, "--out", Out, "--images", "copy"]);

        operations.AssertOrder(
            "rename in/out/images/train/00000001.png",
            "open in/out/images/train/00000001.png",
            "open in/out/images/train",
            "rename in/out/manifest.jsonl",
            "open in/out/manifest.jsonl",
            "rename in/out/export.json",
            "open in/out/export.json",
            "delete in/out/.export/plan.json",
            "open in/out"
        );
    }

    [CompilerFact]
    [Trait("Category", "Heavy")]
    public void Merge_in_place_flushes_the_shards_that_are_there()
    {
        string[] shards = Shards();

        RecordedOperations operations = RecordIn(_folder.PathOf("shards"), ["merge", .. shards, "--out", shards[0]]);

        operations.AssertOrder("open 1/images/train/00000000.png", "rename 1/manifest.jsonl");
    }

    [CompilerFact]
    [Trait("Category", "Heavy")]
    public void Export_and_merge_never_wait_if_they_need_not()
    {
        string[] shards = Shards();

        RecordedOperations merge = Record(["merge", .. shards, "--out", Out, "--sync", "never"]);
        RecordedOperations export = Record("export", session.Folder, "--format", "yolo", "--out", Out + "2", "--sync", "never");

        foreach (RecordedOperations operations in (RecordedOperations[])[merge, export])
        {
            Assert.Empty(operations.Paths("flush"));
            Assert.DoesNotContain("in/out/images/train", operations.Paths("open"));
            Assert.DoesNotContain("in/out2/images/train", operations.Paths("open"));
        }
    }

    [CompilerFact]
    [Trait("Category", "Heavy")]
    public void Former_session_is_deleted_when_the_new_name_is_on_the_disk()
    {
        SharedHarvest.CopyTo(Out, "--frames", "1", "--seed", "5", "--size", "64x48", "--masks", "--no-report");

        RecordedOperations operations = Record("relabel", session.Folder, "--out", Out, "--overwrite", "--no-report");

        operations.AssertOrder(
            "flush in/out.*.partial/out/session.json.*.partial",
            "open in/out.*.partial",
            "open in",
            "exchange in/out",
            "open in/out.*.partial",
            "open in",
            "delete in/out.*.partial/out/session.json"
        );
    }

    [CompilerFact]
    [Trait("Category", "Heavy")]
    public void Mark_is_on_the_disk_before_the_session_and_gone_after_it()
    {
        RecordedOperations operations = Record("relabel", session.Folder, "--out", Out, "--no-report");

        operations.AssertOrder(
            "flush in/out/.harvester-unfinished.*.partial",
            "rename in/out/.harvester-unfinished",
            "open in/out",
            "rename in/out/session.json",
            "delete in/out/.harvester-unfinished",
            "open in/out"
        );
    }

    [CompilerFact]
    [Trait("Category", "Heavy")]
    public void Single_file_is_on_the_disk_when_the_command_ends()
    {
        Directory.CreateDirectory(_folder.PathOf("root/in"));
        string page = _folder.PathOf("root/in/page.html");
        string still = _folder.PathOf("root/in/still.png");

        Record("report", session.Folder, "--out", page)
            .AssertOrder("flush in/page.html.*.partial", "close in/page.html.*.partial", "rename in/page.html", "open in");
        Record("report", session.Folder, "--still", "0", "--out", still)
            .AssertOrder("flush in/still.png.*.partial", "close in/still.png.*.partial", "rename in/still.png", "open in");
    }

    private string[] Shards()
    {
        string[] shards = [_folder.PathOf("shards/1"), _folder.PathOf("shards/2")];
        foreach ((int index, string shard) in shards.Index())
        {
            string number = $"{index + 1}/2";
            CliRun run = CliRun.Of(
                "export",
                session.Folder,
                "--format",
                "yolo",
                "--out",
                shard,
                "--shard",
                number,
                "--sync",
                "never",
                "--images",
                "copy"
            );
            Assert.Equal((ExitCode.Done, ""), (run.ExitCode, run.Error));
        }

        return shards;
    }

    private RecordedOperations Record(params string[] words) => RecordIn(_folder.PathOf("root"), words);

    private static RecordedOperations RecordIn(string folder, string[] words) => RecordedOperations.Of(folder, words);
}
