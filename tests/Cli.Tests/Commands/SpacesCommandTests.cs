using Harvester.Cli.Terminals;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;

namespace Harvester.Cli.Tests.Commands;

public sealed class SpacesCommandTests : IDisposable
{
    // joaat of prop_sign_road_01a is -949234773.
    private const string Good = "prop_sign_road_01a,-949234773,sign,BIG STOP,R1-1,0,-0.5,-0.04,3,0.5,-0.06,1.5,-y,measured,a test";
    private const string InsideOut = "prop_sign_road_02a,,sign,YIELD,R1-2,0,0.5,-0.04,3,-0.5,-0.06,1.5,-y,measured,a test";

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Check_of_a_valid_table_succeeds()
    {
        string file = _folder.File("spaces.csv", Good + "\n");

        CliRun run = CliRun.Of("spaces", "check", file);

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Equal($"{file}: 1 valid row, 0 invalid\n", run.Out);
    }

    [Fact]
    public void Check_of_a_bad_row_names_line_column_and_reason_and_fails()
    {
        string file = _folder.File("spaces.csv", Good + "\n" + InsideOut + "\n");

        CliRun run = CliRun.Of("spaces", "check", file);

        Assert.Equal(ExitCode.BadData, run.ExitCode);
        Assert.StartsWith(
            $"{file}: line 2, fulX, blrX: the cuboid is inside out: fulX must be less than blrX.",
            run.Out,
            StringComparison.Ordinal
        );
        Assert.EndsWith($"{file}: 1 valid row, 1 invalid\n", run.Out, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("")]
    [InlineData("{\n  \"formatVersion\": 1,\n  \"game\": \"simulation\"\n}\n")]
    [InlineData("\u0089PNG\r\n\u001a\n")]
    [InlineData("# Signs\n\nThis is prose, with commas.\nNot one of its eight words is a number.\n")]
    public void File_that_is_not_a_table_is_refused_in_one_line(string content)
    {
        string file = _folder.File("something", content);

        foreach (string command in (string[])["check", "list", "gallery"])
        {
            CliRun.Of("spaces", command, file).AssertFailed(ExitCode.BadData, $"'{file}' is not a table of faces");
        }

        Assert.Equal(ExitCode.BadData, CliRun.Of("harvest", "--out", _folder.PathOf("session"), "--spaces", file).ExitCode);
    }

    [Theory]
    [InlineData("model,hash,class,name,mutcd,face,fulX,fulY,fulZ,blrX,blrY,blrZ,facing,provenance,source\n", ExitCode.Done)]
    [InlineData(
        "model, hash, class, name, mutcd, face, fulX, fulY, fulZ, blrX, blrY, blrZ, facing, provenance,\"source\"\nstop,1\n",
        ExitCode.BadData
    )]
    [InlineData("# none yet\n", ExitCode.Done)]
    [InlineData(InsideOut + "\n", ExitCode.BadData)]
    public void Check_of_a_table_without_a_valid_row_reports_zero_rows(string content, int code)
    {
        CliRun run = CliRun.Of("spaces", "check", _folder.File("spaces.csv", content));

        Assert.Equal((code, ""), (run.ExitCode, run.Error));
        Assert.Contains(": 0 valid rows, ", run.Out, StringComparison.Ordinal);
    }

    [Fact]
    public void List_shows_the_properties_of_a_face()
    {
        CliRun run = CliRun.Of("spaces", "list", _folder.File("spaces.csv", Good + "\n"));

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Contains("prop_sign_road_01a", run.Out, StringComparison.Ordinal);
        Assert.Contains("1.000 x 1.500", run.Out, StringComparison.Ordinal);
    }

    [Fact]
    public void Gallery_is_one_page_with_every_model_drawn_to_scale()
    {
        _folder.File("spaces.csv", Good.Replace("BIG STOP", "<STOP>", StringComparison.Ordinal) + "\n");

        CliRun run = CliRun.Of("spaces", "gallery", _folder.Path);

        string page = Path.Combine(_folder.Path, "gallery.html");
        Assert.Equal($"{page}: 1 model shown\n", run.Out);
        string html = File.ReadAllText(page);
        Assert.Contains("&lt;STOP&gt;", html, StringComparison.Ordinal);
        Assert.DoesNotContain("src=\"http", html, StringComparison.Ordinal);

        // 70 pixels a metre, 0.3 m of margin around: x from -0.5 - 0.3, z down from 3 + 0.3. An octagon in 1.0 x 1.5 m has its
        // lower left corner at 0.29289 of the width: (0.3 + 0.29289) * 70 = 41.5, and (3.3 - 1.5) * 70 = 126.
        Assert.Contains("points=\"41.5,126 ", html, StringComparison.Ordinal);
        Assert.Equal(ExitCode.BadData, CliRun.Of("spaces", "gallery", _folder.File("bad.csv", InsideOut + "\n")).ExitCode);
    }

    [Fact]
    public void Gallery_draws_the_nearest_face_last_and_averted_faces_pale()
    {
        const string behind = "prop_sign_road_01a,,sign,BEHIND,R2-1,1,-0.7,0.24,2.5,0.3,0.06,1.2,-y,measured,a test";
        const string elsewhere = "prop_sign_road_01a,,sign,ELSEWHERE,R2-1,2,-0.7,0.94,2.5,0.3,0.86,1.2,+y,measured,a test";
        _folder.File("spaces.csv", Good + "\n" + behind + "\n" + elsewhere + "\n");

        CliRun.Of("spaces", "gallery", _folder.Path);

        // 70 pixels a metre, 0.3 m of margin: x from -0.7 - 0.3, z down from 3 + 0.3. The octagon begins at (1 - 0.5 + 0.29289) * 70 =
        // 55.5, and (3.3 - 1.5) * 70 = 126. It stands nearest to the back, towards which it looks: y = -0.06, then 0.06 and 0.86.
        string[] shapes = [.. File.ReadAllText(_folder.PathOf("gallery.html")).Split("<polygon ").Skip(1)];
        Assert.Equal(["measured away", "measured", "measured"], shapes.Select(shape => shape.Split('"')[1]));
        Assert.Contains("points=\"55.5,126 ", shapes[2], StringComparison.Ordinal);
    }

    [Fact]
    public void Gallery_draws_cuboids_on_photos_and_models_without_a_face()
    {
        _folder.File("spaces.csv", Good + "\n");
        Directory.CreateDirectory(_folder.PathOf("photos"));
        _folder.File(Path.Combine("photos", "prop_sign_road_01a.png"), "a picture");
        _folder.File(Path.Combine("photos", "prop_sign_road_03g.png"), "another");
        _folder.File(
            "photos.csv",
            "file,model,x,y,z,pitch,roll,yaw,verticalFov\n"
                + "prop_sign_road_01a.png,prop_sign_road_01a,0,-4.06,2.25,0,0,0,53.13010235\n"
                + "prop_sign_road_03g.png,prop_sign_road_03g,0,-4,2,0,0,0,50\n"
                + "prop_sign_road_03h.png,prop_sign_road_03h,0,-4,2,0,0,0,50\n"
        );

        CliRun run = CliRun.Of("spaces", "gallery", _folder.Path);

        // 2 atan(1/2) = 53.13° over 320 pixels: f = 320. The face's near side is 4 m away: its corners lie 0.5 / 4 * 320 = 40 pixels beside
        // and 0.75 / 4 * 320 = 60 above and below the middle.
        Assert.Equal($"{_folder.PathOf("gallery.html")}: 2 models shown\n", run.Out);
        string html = File.ReadAllText(_folder.PathOf("gallery.html"));
        string seen = html.Split("<path class=\"measured\"")[1].Split("/>")[0];
        string hidden = html.Split("<path class=\"measured hidden\"")[1].Split("/>")[0];
        Assert.Contains("M120 220L200 220", seen, StringComparison.Ordinal);
        Assert.Contains("M120 220L120 100", seen, StringComparison.Ordinal);

        // Straight before the face nothing but its near side is seen: four edges of twelve.
        Assert.Equal((4, 8), (seen.Count(letter => letter == 'M'), hidden.Count(letter => letter == 'M')));
        Assert.Contains("<h2>prop_sign_road_03g</h2><svg class=\"photo\"", html, StringComparison.Ordinal);
        Assert.DoesNotContain("prop_sign_road_03h", html, StringComparison.Ordinal);
    }

    [Fact]
    public void Gallery_shows_a_flat_face_completely_on_its_photo()
    {
        _folder.File("spaces.csv", Good.Replace("-0.04,", "-0.06,", StringComparison.Ordinal) + "\n");
        Directory.CreateDirectory(_folder.PathOf("photos"));
        _folder.File(Path.Combine("photos", "stop.png"), "a picture");
        _folder.File(
            "photos.csv",
            "file,model,x,y,z,pitch,roll,yaw,verticalFov\nstop.png,prop_sign_road_01a,0,-4.06,2.25,0,0,0,53.13010235\n"
        );

        Assert.Equal(ExitCode.Done, CliRun.Of("spaces", "gallery", _folder.Path).ExitCode);

        // Its near and its far side are one, so that none of the twelve edges is hidden.
        string html = File.ReadAllText(_folder.PathOf("gallery.html"));
        Assert.Contains("<path class=\"measured hidden\" fill=\"none\" stroke=\"#f0f\" d=\"\" />", html, StringComparison.Ordinal);
    }

    [Fact]
    public void Survey_folder_is_accepted_in_place_of_its_table()
    {
        _folder.File("spaces.csv", Good + "\n");

        Assert.Contains("1 valid row", CliRun.Of("spaces", "check", _folder.Path).Out, StringComparison.Ordinal);
        Assert.Contains("prop_sign_road_01a", CliRun.Of("spaces", "list", _folder.Path).Out, StringComparison.Ordinal);
    }

    [Fact]
    public void List_counts_omitted_rows()
    {
        CliRun run = CliRun.Of("spaces", "list", _folder.File("spaces.csv", Good + "\n" + InsideOut + "\n"));

        Assert.Equal(
            (ExitCode.BadData, "harvester: 1 invalid row not listed. For the reasons, run 'harvester spaces check'.\n"),
            (run.ExitCode, run.Error)
        );
        Assert.Contains("prop_sign_road_01a", run.Out, StringComparison.Ordinal);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Harvest_with_spaces_prefers_the_files_rows()
    {
        string session = _folder.PathOf("session");
        string file = _folder.File("spaces.csv", Good + "\n");
        CliRun run = CliRun.Of(
            "harvest",
            "--out",
            session,
            "--frames",
            "6",
            "--hz",
            "0.5",
            "--size",
            "320x240",
            "--no-report",
            "--spaces",
            file
        );
        Assert.Equal("", run.Error);

        List<ObjectLabel> parts =
        [
            .. new SessionReader(session).ReadLabels().SelectMany(label => label.Objects).Where(item => item.Face is not null),
        ];
        Assert.Contains(parts, part => part.Name == "TRAFFIC LIGHT");
        Assert.All(parts.Where(part => part.Model == "prop_sign_road_01a"), part => Assert.Equal("BIG STOP", part.Name));
        Assert.Equal(ExitCode.Done, CliRun.Of("validate", session).ExitCode);
    }

    [Fact]
    public void Refused_row_is_reported_and_the_others_are_used()
    {
        string file = _folder.File("spaces.csv", InsideOut + "\n" + Good + "\n");
        string session = _folder.PathOf("session");

        CliRun[] runs =
        [
            CliRun.Of("harvest", "--out", session, "--frames", "1", "--size", "64x48", "--no-report", "--spaces", file),
            CliRun.Of("relabel", session, "--out", _folder.PathOf("relabelled"), "--no-report", "--spaces", file),
            CliRun.Of("spaces", "gallery", file),
        ];

        Assert.All(
            runs,
            run =>
            {
                Assert.Equal(ExitCode.Done, run.ExitCode);
                Assert.Contains($"{file}: line 1, fulX", run.Error, StringComparison.Ordinal);
                Assert.Contains("1 of 2 rows are invalid and are ignored", run.Error, StringComparison.Ordinal);
            }
        );
        Assert.Contains("BIG STOP", File.ReadAllText(Path.Combine(session, "scenes", "spaces.csv")), StringComparison.Ordinal);
    }

    [Fact]
    public void Harvest_with_a_table_without_a_valid_row_fails()
    {
        string file = _folder.File("spaces.csv", InsideOut + "\n");

        CliRun.Of("harvest", "--out", _folder.PathOf("session"), "--spaces", file).AssertFailed(ExitCode.BadData, "line 1, fulX");
    }
}
