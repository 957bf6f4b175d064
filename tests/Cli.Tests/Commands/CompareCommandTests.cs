using System.Text.Json;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Commands;

public sealed class CompareCommandTests : IDisposable
{
    private const string Hostile = "a<script>alert('1')<!--&amp;";

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Comparison_prints_a_table_and_writes_page_and_JSON()
    {
        string session = Session("day");
        string page = _folder.PathOf("page.html");
        string json = _folder.PathOf("figures.json");

        CliRun run = CliRun.Of("compare", session, session, "--out", page, "--json", json);

        run.AssertDone();
        Assert.StartsWith("day: 3 frames, ", run.Out, StringComparison.Ordinal);
        Assert.EndsWith(page + "\n", run.Out, StringComparison.Ordinal);
        Assert.Matches(@"\n *Distance, m +[0-9.]+ +[0-9.]+ +0 +0 *\n", run.Out);
        JsonElement figures = JsonDocument.Parse(File.ReadAllText(json)).RootElement;
        Assert.Equal(0, figures.GetProperty("quantities").GetProperty("brightness").GetProperty("wasserstein").GetDouble());
        Assert.Equal(3, figures.GetProperty("quantities").GetProperty("brightness").GetProperty("first").GetProperty("count").GetInt32());
        Assert.Equal(0, figures.GetProperty("classes").GetProperty("totalVariation").GetDouble());
        Assert.Contains("28742", File.ReadAllText(page), StringComparison.Ordinal);
    }

    [Fact]
    public void Same_datasets_give_the_same_bytes()
    {
        string session = Session("day");

        string[] names = ["one", "two"];
        byte[][] pages =
        [
            .. names.Select(name =>
            {
                CliRun.Of("compare", session, session, "--out", _folder.PathOf($"{name}.html")).AssertDone();
                return File.ReadAllBytes(_folder.PathOf($"{name}.html"));
            }),
        ];

        Assert.Equal(pages[0], pages[1]);
    }

    [Fact]
    public void Names_of_datasets_are_text_in_the_page()
    {
        if (OperatingSystem.IsWindows())
        {
            return;
        }

        string session = Session(Hostile);
        string page = _folder.PathOf("page.html");

        CliRun.Of("compare", session, session, "--out", page).AssertDone();

        Assert.DoesNotContain("<script", File.ReadAllText(page), StringComparison.OrdinalIgnoreCase);
        Assert.Contains("a&lt;script&gt;alert('1')&lt;!--&amp;amp;", File.ReadAllText(page), StringComparison.Ordinal);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Session_is_compared_with_KITTI_labels()
    {
        string session = Session("day");
        Directory.CreateDirectory(_folder.PathOf("kitti/label_2"));
        _folder.File("kitti/label_2/000000.txt", "Tram 0 0 0 1 1 31 41 3 2 9 0 1 20 0\n");

        CliRun run = CliRun.Of("compare", session, "--kitti", _folder.PathOf("kitti"), "--out", _folder.PathOf("page.html"));

        run.AssertDone();
        Assert.Contains("\nkitti: 1 frame, 1 label\n", run.Out, StringComparison.Ordinal);
        Assert.Matches(@"\n *Image brightness, of 255 +[0-9.]+ +none +none +none *\n", run.Out);
    }

    [Theory]
    [InlineData]
    [InlineData("OTHER", "--kitti", "KITTI")]
    [InlineData("--kitti", "KITTI", "--nuscenes", "TABLES")]
    public void Exactly_one_dataset_to_compare_with_is_needed(params string[] others) =>
        CliRun.Of(["compare", "session", .. others]).AssertFailed(ExitCode.Usage, "Name one dataset to compare with");

    [Theory]
    [InlineData("--out", "page.png", "--out takes a file that ends in .html or .htm, not 'page.png'.")]
    [InlineData("--json", "figures.txt", "--json takes a file that ends in .json, not 'figures.txt'.")]
    public void Wrong_extension_is_refused(string option, string file, string message) =>
        CliRun.Of("compare", "session", "other", option, file).AssertFailed(ExitCode.Usage, message);

    [Fact]
    public void File_of_a_dataset_is_not_replaced()
    {
        string session = Session("day");

        CliRun
            .Of("compare", session, session, "--out", _folder.PathOf("page.html"), "--json", Path.Combine(session, "session.json"))
            .AssertFailed(ExitCode.Usage, "would replace a file of a dataset");
    }

    [Fact]
    public void Missing_dataset_is_an_input_error()
    {
        string session = Session("day");

        CliRun.Of("compare", session, "--kitti", _folder.PathOf("none")).AssertFailed(ExitCode.InputOutput, "none");
        CliRun.Of("compare", session, "--nuscenes", _folder.PathOf("none")).AssertFailed(ExitCode.InputOutput, "none");
        CliRun.Of("compare", session, _folder.PathOf("none")).AssertFailed(ExitCode.InputOutput, "none");
    }

    [Fact]
    public void Malformed_nuScenes_table_is_named_with_its_line()
    {
        string session = Session("day");
        foreach (string table in new[] { "instance", "sensor", "calibrated_sensor", "sample_data", "ego_pose", "sample_annotation" })
        {
            _folder.File($"{table}.json", "[]\n");
        }

        _folder.File("category.json", "[\n{ \"token\": \"a\" }\n]\n");

        CliRun
            .Of("compare", session, "--nuscenes", _folder.Path, "--out", _folder.PathOf("page.html"))
            .AssertFailed(ExitCode.BadData, "category.json', line 2: name is missing");
    }

    private string Session(string name)
    {
        string session = _folder.PathOf(name);
        SharedHarvest.CopyTo(session, "--frames", "3", "--seed", "5", "--size", "80x60", "--no-report");
        return session;
    }
}
