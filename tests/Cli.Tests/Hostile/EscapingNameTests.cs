using Harvester.Cli.Terminals;
using Harvester.Cli.Tests.Commands;
using Harvester.TestSupport;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>Names that a session, a dataset or a table gives for files lead nowhere but into its own folder.</summary>
public sealed class EscapingNameTests(SmallSession session) : IClassFixture<SmallSession>, IDisposable
{
    private const string Secret = "the secret of somebody";
    private readonly HostileSession _hostile = new(session);

    public void Dispose() => _hostile.Dispose();

    [Theory]
    [InlineData("../.bashrc")]
    [InlineData("ABSOLUTE")]
    [InlineData("images/../../.bashrc")]
    [InlineData("..\\\\.bashrc")]
    public void Merge_writes_no_file_that_a_journal_names_outside(string name)
    {
        string[] shards = ExportShards("csv");
        File.WriteAllText(_hostile.PathOf("shards/.bashrc"), Secret);
        Directory.CreateDirectory(_hostile.PathOf("b"));
        File.WriteAllText(_hostile.PathOf("b/.bashrc"), "mine");
        string absolute = _hostile.PathOf("absolute").Replace('\\', '/');
        string named = name.Replace("ABSOLUTE", absolute, StringComparison.Ordinal);
        EditJournal(shards[0], "\"images/00000000.png\"", $"\"{named}\"");

        HostileSession.AssertRefused("points outside", ["merge", .. shards, "--out", _hostile.PathOf("b/out")]);

        Assert.Equal("mine", File.ReadAllText(_hostile.PathOf("b/.bashrc")));
        Assert.False(File.Exists(absolute));
    }

    [Fact]
    public void Merge_packs_no_file_from_outside_into_an_archive()
    {
        string[] shards = ExportShards("webdataset");
        string secret = _hostile.PathOf("secret");
        File.WriteAllText(secret, Secret);
        EditJournal(shards[0], "\".export/staged/00000000.tar\"]}", $"\"{secret.Replace('\\', '/')}\"]}}");

        HostileSession.AssertRefused("points outside", ["merge", .. shards, "--out", _hostile.PathOf("out")]);

        AssertNothingHolds(_hostile.PathOf("out"), Secret);
    }

    [Theory]
    [InlineData("../../id_rsa", false)]
    [InlineData("link.png", true)]
    public void Gallery_shows_no_picture_from_outside(string name, bool isLink)
    {
        File.WriteAllText(_hostile.PathOf("id_rsa"), Secret);
        string table = SurveyWith($"{name},prop_sign_road_01a,0,-3,0,0,0,0,50");
        string photos = Path.Combine(Path.GetDirectoryName(table)!, "photos");
        Directory.CreateDirectory(photos);
        if (isLink && !OperatingSystem.IsWindows())
        {
            File.CreateSymbolicLink(Path.Combine(photos, name), _hostile.PathOf("id_rsa"));
        }

        string page = _hostile.PathOf("gallery.html");
        Assert.Equal(ExitCode.Done, HostileSession.Run("spaces", "gallery", table, "--out", page).ExitCode);

        Assert.DoesNotContain(Base64(Secret), File.ReadAllText(page), StringComparison.Ordinal);
    }

    [Fact]
    public void Gallery_shows_no_picture_outside_that_a_model_names()
    {
        File.WriteAllText(_hostile.PathOf("id_rsa.png"), Secret);
        string table = SurveyWith("", "../id_rsa");

        string page = _hostile.PathOf("gallery.html");
        HostileSession.Run("spaces", "gallery", table, "--out", page);

        Assert.False(File.Exists(page) && File.ReadAllText(page).Contains(Base64(Secret), StringComparison.Ordinal));
    }

    public static TheoryData<string> ReadersOfPictures =>
        [
            "report SESSION",
            "report SESSION --link --out OUT.html",
            "report SESSION --still 0 --out OUT.png",
            "export SESSION --format csv --out OUT",
            "export SESSION --format csv --image-format jpg --out OUT",
            "export SESSION --format webdataset --out OUT",
            "relabel SESSION --no-report --out OUT",
            "validate SESSION",
        ];

    [PosixTheory]
    [MemberData(nameof(ReadersOfPictures))]
    public void Picture_linked_from_outside_is_refused(string command)
    {
        string secret = _hostile.PathOf("secret.png");
        File.Move(_hostile.In("frames/00000000.png"), secret);
        File.CreateSymbolicLink(_hostile.In("frames/00000000.png"), secret);

        AssertRefusedAndNotCopied(command, secret);
    }

    [PosixTheory]
    [MemberData(nameof(ReadersOfPictures))]
    public void Folder_of_pictures_linked_from_outside_is_refused(string command)
    {
        Directory.Move(_hostile.In("frames"), _hostile.PathOf("elsewhere"));
        File.CreateSymbolicLink(_hostile.In("frames"), _hostile.PathOf("elsewhere"));

        AssertRefusedAndNotCopied(command, _hostile.PathOf("elsewhere/00000000.png"));
    }

    [Theory]
    [MemberData(nameof(ReadersOfPictures))]
    public void Picture_named_outside_is_refused(string command)
    {
        string secret = _hostile.PathOf("a/secret.png");
        File.Move(_hostile.In("frames/00000000.png"), secret);
        _hostile.Replace("labels.jsonl", "frames/00000000.png", "../secret.png");

        AssertRefusedAndNotCopied(command, secret);
    }

    [PosixFact]
    public void Picture_that_is_a_link_within_the_session_is_read()
    {
        File.Move(_hostile.In("frames/00000000.png"), _hostile.In("frames/first.png"));
        File.CreateSymbolicLink(_hostile.In("frames/00000000.png"), "first.png");

        Assert.Equal(ExitCode.Done, HostileSession.Run("validate", _hostile.Folder).ExitCode);
    }

    [PosixFact]
    public void Session_that_is_itself_behind_a_link_is_read()
    {
        File.CreateSymbolicLink(_hostile.PathOf("link"), _hostile.Folder);

        Assert.Equal(ExitCode.Done, HostileSession.Run("validate", _hostile.PathOf("link")).ExitCode);
    }

    [PosixFact]
    public void Import_of_masks_reads_no_link_out_of_its_folder()
    {
        Directory.CreateDirectory(_hostile.PathOf("maps"));
        File.CreateSymbolicLink(_hostile.PathOf("maps/0.png"), _hostile.In("masks/00000000.png"));

        HostileSession.AssertRefused("is a link that points outside", "masks", "import", _hostile.Folder, _hostile.PathOf("maps"));
    }

    [PosixFact]
    public void Import_of_roads_reads_no_link_out_of_its_folder()
    {
        Directory.CreateDirectory(_hostile.PathOf("roads"));
        File.CreateSymbolicLink(_hostile.PathOf("roads/nodes.csv"), _hostile.In("scenes/roads.csv"));

        HostileSession.AssertRefused("is a link that points outside", "roads", "info", _hostile.PathOf("roads"));
    }

    private static string Base64(string text) => Convert.ToBase64String(System.Text.Encoding.UTF8.GetBytes(text));

    private static void AssertNothingHolds(string folder, string text)
    {
        string[] files = Directory.Exists(folder) ? Directory.GetFiles(folder, "*", SearchOption.AllDirectories) : [];
        Assert.All(
            files,
            file => Assert.DoesNotContain(text, System.Text.Encoding.Latin1.GetString(File.ReadAllBytes(file)), StringComparison.Ordinal)
        );
    }

    private static void EditJournal(string shard, string old, string with)
    {
        string journal = Directory.GetFiles(Path.Combine(shard, ".export"), "journal-*").Single();
        string text = File.ReadAllText(journal);
        Assert.Contains(old, text, StringComparison.Ordinal);
        File.WriteAllText(journal, text.Replace(old, with, StringComparison.Ordinal));
    }

    private string[] ExportShards(string format)
    {
        string[] folders = [_hostile.PathOf("shards/1"), _hostile.PathOf("shards/2")];
        for (int i = 0; i < folders.Length; i++)
        {
            Assert.Equal(
                ExitCode.Done,
                CliRun.Of("export", _hostile.Folder, "--format", format, "--shard", $"{i + 1}/2", "--out", folders[i]).ExitCode
            );
        }

        return folders;
    }

    private string SurveyWith(string photo, string model = "prop_sign_road_01a")
    {
        Directory.CreateDirectory(_hostile.PathOf("survey"));
        File.WriteAllText(_hostile.PathOf("survey/photos.csv"), $"file,model,x,y,z,pitch,roll,yaw,verticalFov\n{photo}\n");
        string table = _hostile.PathOf("survey/spaces.csv");
        File.WriteAllText(table, $"{model},,sign,STOP,R1-1,0,-0.5,-0.04,3,0.5,-0.06,1.5,-y,measured,a test\n");
        return table;
    }

    private void AssertRefusedAndNotCopied(string command, string secret)
    {
        string output = _hostile.PathOf("out");
        HostileSession.AssertRefused(
            "points outside",
            [
                .. command
                    .Split(' ')
                    .Select(word =>
                        word.Replace("OUT", output, StringComparison.Ordinal).Replace("SESSION", _hostile.Folder, StringComparison.Ordinal)
                    ),
            ]
        );

        Assert.False(File.Exists(output + ".png") || File.Exists(output + ".html"));
        byte[] content = File.ReadAllBytes(secret);
        string[] written = Directory.Exists(output) ? Directory.GetFiles(output, "*", SearchOption.AllDirectories) : [];
        Assert.All(written, file => Assert.NotEqual(content, File.ReadAllBytes(file)));
    }
}
