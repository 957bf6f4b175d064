using System.Windows.Forms;
using GTA.Hosting;
using GTA.Native;
using Harvester.Geometry;
using Harvester.Mod.Tests.Games;
using Harvester.Play.Features;
using Harvester.Play.Surveys.Faces;
using Harvester.Sessions.Faces;
using Harvester.Simulation.Tests.Faces.Survey;

namespace Harvester.Mod.Tests;

public sealed class SpaceSurveyTests
{
    private const string Light = "prop_traffic_01b";
    private const string Sign = "prop_sign_road_03g";
    private const string Ini = "[Signs]\nModels = " + Light + "\n";

    /// <summary>The required accuracy of a face's position.</summary>
    private const double ToleranceMetres = 0.02;

    [Fact]
    public void Key_measures_all_models_of_the_game_and_removes_them()
    {
        using ScriptDriver driver = NewDriver();
        driver.Press(Keys.Multiply);
        driver.UntilMessage("All 109 models are surveyed: 3 faces");
        driver.WaitForDisk();

        FaceTable table = new SurveyFolder(Folder(driver)).Table;
        AssertFaces(KnownProps.All["octagon"], table.Of(Sign));
        AssertFaces(KnownProps.All[Light], table.Of(Light));
        Assert.Empty(driver.Game.Objects);
        Assert.Empty(driver.Game.Cameras);
        Assert.Equal(-1, driver.Game.RenderingCamera);
        Assert.Equal(0, driver.Game.RequestedModels);
        Assert.Empty(driver.Game.LeakedScriptHandles);
    }

    [Fact]
    public void Models_are_placed_frozen_in_the_air_above_the_player()
    {
        using ScriptDriver driver = NewDriver();
        driver.Press(Keys.Multiply);
        driver.Until(() => driver.Game.Objects.Any());

        GameEntity prop = Assert.Single(driver.Game.Objects);
        Assert.True(prop.IsFrozen);
        Assert.Equal(driver.Game.Entities[TestGame.Player].Pose.Position + new Vector3D(0, 0, 40), prop.Pose.Position);
    }

    [Fact]
    public void Photographs_show_front_and_back_without_overlays()
    {
        using ScriptDriver driver = NewDriver();
        driver.Press(Keys.L);
        driver.Press(Keys.Multiply);
        driver.UntilMessage("models are surveyed");
        driver.WaitForDisk();

        string folder = Path.Combine(Folder(driver), SurveyPhoto.FolderName);
        Assert.Equal(
            [Sign + ".png", Sign + "_back.png", Light + ".png", Light + "_back.png"],
            Directory.GetFiles(folder).Select(Path.GetFileName).Order(StringComparer.Ordinal)
        );
        Assert.Equal((4, 0), (driver.Screen.Grabs, driver.Screen.SpoiltPictures));
        IReadOnlyList<SurveyPhoto> photos = SurveyPhoto.ReadAll(Folder(driver));
        Assert.Equal(4, photos.Count);

        // The octagon's face looks back, is 2 x 0.4 m x cos 22.5° = 0.74 m wide and lies at y = -0.06: the camera stands 1.5 x 0.37 / tan
        // 25° = 1.19 m before it.
        SurveyPhoto front = photos.Single(photo => photo.File == Sign + ".png");
        Assert.Equal(-0.06 - 1.19, front.Camera.Position.Y, 0.02);
        Assert.Equal(2.3, front.Camera.Position.Z, 0.02);
        Assert.Equal(1, front.Camera.Axes.Forward.Y, 6);
        Assert.Equal(-1, photos.Single(photo => photo.File == Sign + "_back.png").Camera.Axes.Forward.Y, 6);
    }

    [Fact]
    public void Refused_pictures_are_omitted_and_the_survey_continues()
    {
        using ScriptDriver driver = NewDriver();
        driver.Screen.Refusal = "covered";
        driver.Press(Keys.Multiply);
        driver.UntilMessage("3 faces");
        driver.WaitForDisk();

        Assert.Empty(Directory.GetFiles(Path.Combine(Folder(driver), SurveyPhoto.FolderName)));
    }

    [Fact]
    public void Photographs_can_be_switched_off()
    {
        using ScriptDriver driver = NewDriver(Ini + "Photographs = Off\n");
        driver.Press(Keys.Multiply);
        driver.UntilMessage("3 faces");

        Assert.Equal(0, driver.Screen.Grabs);
        Assert.DoesNotContain(Hash.CREATE_CAM_WITH_PARAMS, driver.Game.Calls);
    }

    [Fact]
    public void Status_line_shows_the_progress()
    {
        using ScriptDriver driver = NewDriver();
        driver.Press(Keys.Multiply);
        driver.Until(() => driver.Game.Objects.Any());

        Assert.Contains(
            driver.Game.Texts,
            text => text.StartsWith("SIGNS  ", StringComparison.Ordinal) && text.Contains(" of 109  prop_", StringComparison.Ordinal)
        );
        driver.Press(Keys.Multiply);
        Assert.Matches("was stopped after [0-9]+ of 109 models[.] The next", driver.Game.Notifications[^1]);
        Assert.Empty(driver.Game.Objects);
        driver.Tick();
        Assert.Empty(driver.Game.Texts);
    }

    [Fact]
    public void Key_while_the_last_rows_are_written_does_not_stop_the_survey()
    {
        using ScriptDriver driver = NewDriver();
        driver.Press(Keys.Multiply);
        for (bool isLast = false; !isLast; driver.Tick())
        {
            isLast =
                driver.Game.Texts.Any(text => text.StartsWith("SIGNS  109 of 109", StringComparison.Ordinal))
                || driver.Game.Notifications.Count > 1;
        }

        driver.Script.RaiseKeyUp(Keys.Multiply);
        driver.UntilMessage("All 109 models are surveyed: 3 faces");

        Assert.DoesNotContain(driver.Game.Notifications, shown => shown.Contains("stopped after 109", StringComparison.Ordinal));
    }

    [Fact]
    public void Survey_stopped_before_its_first_model_names_no_number()
    {
        using ScriptDriver driver = NewDriver();
        driver.Script.RaiseKeyUp(Keys.Multiply);
        driver.Script.RaiseKeyUp(Keys.Multiply);

        Assert.EndsWith("The survey of signs was stopped before its first model.", driver.Game.Notifications[^1], StringComparison.Ordinal);
    }

    [Fact]
    public void Stopped_or_aborted_survey_resumes_with_the_remaining_models()
    {
        using ScriptDriver driver = NewDriver();
        driver.Press(Keys.Multiply);
        driver.Until(() => driver.Game.Objects.Any(prop => prop.Name == Light));

        var other = new Thread(driver.Script.RaiseAborted);
        other.Start();
        other.Join();
        Assert.Empty(driver.Game.Objects);
        Assert.Empty(driver.Game.Cameras);
        Assert.Equal(0, driver.Game.RequestedModels);
        Assert.Single(new SurveyFolder(Folder(driver)).Table.Faces);

        driver.Reload();
        var seen = new HashSet<string>();
        driver.Game.PassFrame = () => seen.UnionWith(driver.Game.Objects.Select(prop => prop.Name));
        driver.Press(Keys.Multiply);
        driver.UntilMessage("3 faces");
        Assert.Equal([Light], seen);
    }

    [Fact]
    public void Full_object_pool_and_models_that_never_load_are_skipped()
    {
        using ScriptDriver driver = NewDriver();
        driver.Game.ObjectPoolIsFull = true;
        driver.Press(Keys.Multiply);
        driver.UntilMessage("All 109 models are surveyed: 0 faces");
        driver.WaitForDisk();

        Assert.Contains(Sign + " refused", File.ReadAllLines(Path.Combine(Folder(driver), "models.txt")));
        Assert.Equal(0, driver.Game.RequestedModels);
    }

    [Fact]
    public void Measured_faces_override_the_shipped_ones_after_a_restart()
    {
        const string shipped = "prop_sign_road_03g,,sign,A SIGN,R1-1,0,-0.4,0.1,2.7,0.4,-0.1,1.9,-y,estimated,test\n";
        using ScriptDriver driver = NewDriver(faces: shipped);
        driver.Press(Keys.Multiply);
        driver.UntilMessage("models are surveyed");
        driver.WaitForDisk();
        FaceTable used = new ModFolder(driver.Folder).FacesWith(Folder(driver));

        ModelFace face = Assert.Single(used.Of(Sign));
        Assert.Equal((Provenance.Measured, "A SIGN", "R1-1"), (face.Provenance, face.Name, face.MutcdCode));
    }

    [Fact]
    public void Measured_faces_are_labelled_without_a_restart()
    {
        using ScriptDriver driver = NewDriver();
        HarvestTests.Street(driver.Game);
        driver.Press(Keys.Multiply);
        driver.UntilMessage("models are surveyed: 3 faces");
        driver.WaitForDisk();
        Assert.Contains("in use from now on", driver.Game.Notifications[^1], StringComparison.Ordinal);
        driver.Game.Add(TestGame.Standing(Light, KnownProps.All[Light], new Pose(new Vector3D(101, 215, 0), Axes.Identity)));
        driver.Press(Keys.K);
        driver.Tick(20);
        driver.WaitForDisk();

        string session = Assert.Single(Directory.GetDirectories(driver.Output, "singles*"));
        Assert.Contains(
            "\"provenance\":\"measured\"",
            File.ReadAllText(Path.Combine(session, "labels.jsonl")).Replace(" ", "", StringComparison.Ordinal),
            StringComparison.Ordinal
        );
    }

    [Fact]
    public void Damaged_table_is_reported_and_left_unchanged()
    {
        using ScriptDriver driver = NewDriver();
        Directory.CreateDirectory(Folder(driver));
        string file = Path.Combine(Folder(driver), SurveyFolder.TableName);
        File.WriteAllText(file, "prop_sign_road_01a,5,sign\n");
        driver.Press(Keys.Multiply);
        driver.UntilMessage("The survey of signs failed: " + file);
        driver.Tick(50);
        driver.WaitForDisk();

        Assert.Equal("prop_sign_road_01a,5,sign\n", File.ReadAllText(file));
        Assert.Empty(driver.Game.Objects);
    }

    [Fact]
    public void Full_disk_ends_the_survey_with_a_message()
    {
        using ScriptDriver driver = NewDriver();
        driver.Press(Keys.Multiply);
        driver.Until(() => driver.Game.Objects.Any());

        // A folder where the file should be written: the system refuses that.
        driver.WaitForDisk();
        string table = Path.Combine(Folder(driver), SurveyFolder.TableName);
        File.Delete(table);
        Directory.CreateDirectory(table);
        driver.UntilMessage("The survey stopped: ");
        Assert.Empty(driver.Game.Objects);
        Assert.Empty(driver.Game.Cameras);
    }

    [Fact]
    public void Model_deleted_by_the_game_ends_the_survey_and_is_retried()
    {
        using ScriptDriver driver = NewDriver();
        driver.Press(Keys.Multiply);
        driver.Until(() => driver.Game.Objects.Any(prop => prop.Name == Light));

        driver.Game.Entities.Remove(driver.Game.HandleOf(driver.Game.Objects.Single()));
        driver.UntilMessage("the game removed");
        Assert.DoesNotContain(driver.Game.Notifications, message => message.Contains("are surveyed", StringComparison.Ordinal));
        driver.Press(Keys.Multiply);
        driver.UntilMessage("All 109 models are surveyed: 3 faces");
        Assert.Empty(driver.Game.Objects);
    }

    [Fact]
    public void Survey_and_harvest_wait_for_each_other()
    {
        using ScriptDriver driver = NewDriver();
        HarvestTests.Street(driver.Game);
        driver.Press(Keys.Multiply);
        driver.Press(Keys.J);
        Assert.Contains("The survey of signs is running", driver.Game.Notifications[^1], StringComparison.Ordinal);
        driver.Press(Keys.Multiply);
        driver.Press(Keys.J);
        driver.Press(Keys.Multiply);
        Assert.Contains("End the harvest first", driver.Game.Notifications[^1], StringComparison.Ordinal);
        driver.Press(Keys.J);
        driver.WaitForDisk();
        driver.Press(Keys.Multiply);
        Assert.Contains("Unmount the camera first", driver.Game.Notifications[^1], StringComparison.Ordinal);
        driver.Press(Keys.O);
        driver.Press(Keys.Multiply);
        Assert.Contains("is on", driver.Game.Notifications[^1], StringComparison.Ordinal);
        driver.Press(Keys.I);
        driver.Tick();
        Assert.Contains("because the camera was mounted", driver.Game.Notifications[^1], StringComparison.Ordinal);
        Assert.Single(driver.Game.Cameras);
    }

    private static ScriptDriver NewDriver(string ini = Ini, string? faces = "# none\n")
    {
        var driver = new ScriptDriver(ini, faces: faces);
        driver.Game.Props[Sign] = KnownProps.All["octagon"];
        driver.Game.Props[Light] = KnownProps.All[Light];
        return driver;
    }

    private static string Folder(ScriptDriver driver) => Path.Combine(driver.Output, "spaces");

    private static void AssertFaces(Prop prop, IReadOnlyList<ModelFace> found)
    {
        Assert.Equal(prop.Faces.Count, found.Count);
        Assert.All(
            prop.Faces,
            face =>
                Assert.Contains(
                    found,
                    row =>
                        row.Facing == face.Facing
                        && Math.Abs(row.FrontUpperLeft.X - face.Min.X) < ToleranceMetres
                        && Math.Abs(row.FrontUpperLeft.Z - face.Max.Z) < ToleranceMetres
                        && Math.Abs(row.BackLowerRight.X - face.Max.X) < ToleranceMetres
                        && Math.Abs(row.BackLowerRight.Z - face.Min.Z) < ToleranceMetres
                        && Math.Abs(row.BackLowerRight.Y - face.Min.Y) < ToleranceMetres
                )
        );
    }
}
