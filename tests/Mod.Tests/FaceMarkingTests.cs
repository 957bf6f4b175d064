using System.Windows.Forms;
using GTA.Hosting;
using GTA.Native;
using Harvester.Geometry;
using Harvester.Mod.Tests.Games;
using Harvester.Play.Surveys.Faces;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Scenes;

namespace Harvester.Mod.Tests;

public sealed class SpaceMarkingTests
{
    private const string Names = "[Signs]\nNames = STOP|R1-1; ONE WAY|R6-1\n";
    private const string Sign = "prop_sign_road_03h";

    [Fact]
    public void Two_corners_and_a_name_make_a_row_of_the_players_table()
    {
        using ScriptDriver driver = BeforeSign(Names);
        Mark(driver, -0.35, 2.1);
        Assert.Contains(driver.Game.Texts, text => text == $"FACE  {Sign}  (unnamed)  mark the opposite corner");
        Mark(driver, 0.35, 2.7);
        driver.Press(Keys.NumPad3);
        driver.Press(Keys.NumPad3);
        Assert.Contains(driver.Game.Texts, text => text == $"FACE  {Sign}  ONE WAY R6-1");
        Keep(driver);

        ModelFace row = Assert.Single(Rows(driver));
        Assert.Equal((Sign, "ONE WAY", "R6-1", 0, Facing.Back), (row.Model, row.Name, row.MutcdCode, row.Number, row.Facing));
        Assert.Equal(Provenance.Measured, row.Provenance);
        AssertNear(new Vector3D(-0.35, -0.03, 2.7), row.FrontUpperLeft);
        AssertNear(new Vector3D(0.35, -0.05, 2.1), row.BackLowerRight);
        Assert.Empty(driver.Game.Texts);
        Assert.Empty(driver.Game.Rectangles);
    }

    [Fact]
    public void Preview_draws_the_edges_of_the_cuboid()
    {
        using ScriptDriver driver = BeforeSign(Names);
        Mark(driver, -0.35, 2.1);

        // The middle of the window is marked, for the next corner.
        Assert.Equal(new Vector2D(0.5, 0.5), Middle(Assert.Single(driver.Game.Rectangles)));
        Mark(driver, 0.35, 2.7);
        Vector2D[] dots = [.. driver.Game.Rectangles.Select(Middle)];

        // The camera is at y = 186, x = 100.35 and z = 2.7, and the face's front 13.95 m before it, 65 degrees high: the lower left corner
        // is 0.7 m to the left and 0.6 m down, at u = 1/2 - 0.7 / (13.95 * 2 tan 32.5° * 4/3) and v = 1/2 + 0.6 / (13.95 * 2 tan 32.5°).
        Assert.Contains(dots, dot => (dot - new Vector2D(0.5 - 0.02953, 0.5 + 0.03376)).Length < 1e-4);
        Assert.Contains(dots, dot => (dot - new Vector2D(0.5, 0.5)).Length < 1e-4);
        Assert.All(dots, dot => Assert.True(dot.X is > 0.47 and < 0.501 && dot.Y is > 0.499 and < 0.534));
    }

    [Fact]
    public void Overlapping_face_replaces_the_earlier_one_others_are_added()
    {
        using ScriptDriver driver = BeforeSign(Names);
        Mark(driver, -0.35, 2.1);
        Mark(driver, 0.35, 2.7);
        Keep(driver);
        Mark(driver, -0.3, 2.2);
        Mark(driver, 0.3, 2.6);
        Keep(driver);
        Assert.Equal(-0.3, Assert.Single(Rows(driver)).FrontUpperLeft.X, 3);
        Mark(driver, -0.2, 1.1);
        Mark(driver, 0.2, 1.5);
        Keep(driver);

        Assert.Equal([0, 1], Rows(driver).Select(row => row.Number));
    }

    [Fact]
    public void Marked_face_keeps_the_shipped_one_on_the_other_side()
    {
        const string shipped =
            Sign
            + ",,sign,STOP,R1-1,0,-0.4,0.05,2.7,0.4,-0.05,1.9,-y,estimated,test\n"
            + Sign
            + ",,sign,WRONG WAY,R5-1a,1,-0.4,0.05,2.7,0.4,-0.05,1.9,+y,estimated,test\n";
        using ScriptDriver driver = BeforeSign(Names, shipped);
        Mark(driver, -0.35, 2.1);
        Mark(driver, 0.35, 2.7);
        Keep(driver);

        Assert.Equal(
            [(0, Provenance.Measured, Facing.Back), (1, Provenance.Estimated, Facing.Front)],
            Rows(driver).Select(row => (row.Number, row.Provenance, row.Facing))
        );
    }

    [Fact]
    public void Kept_face_is_labelled_at_once_in_a_new_session()
    {
        using ScriptDriver driver = BeforeSign(Names);
        HarvestTests.Street(driver.Game);
        AddSign(driver, new Vector3D(101, 215, 0));
        TakeOne(driver);
        driver.Press(Keys.O);
        MarkOneWay(driver);
        Keep(driver);
        Assert.Contains("in use from now on", driver.Game.Notifications[^1], StringComparison.Ordinal);
        TakeOne(driver);
        TakeOne(driver);

        string[] sessions = [.. Directory.GetDirectories(driver.Output, "singles*").Order(StringComparer.Ordinal)];
        Assert.Equal([1, 2], sessions.Select(session => LabelsIn(session).Length));
        Assert.DoesNotContain("ONE WAY", LabelsIn(sessions[0])[0], StringComparison.Ordinal);
        Assert.All(LabelsIn(sessions[1]), label => Assert.Contains("ONE WAY", label, StringComparison.Ordinal));
    }

    [Fact]
    public void Face_kept_during_a_harvest_is_labelled_in_the_next()
    {
        // The camera clear of the car.
        using ScriptDriver driver = BeforeSign(Names + "[Camera]\nOffsetForward = 4\n");
        HarvestTests.Street(driver.Game);
        AddSign(driver, new Vector3D(100, 215, 0));
        driver.Press(Keys.J);
        driver.Tick();

        // The camera of the harvest is fixed to the car, 0.4 m up, and looks straight ahead.
        GameEntity car = driver.Game.Entities[driver.Game.PlayersVehicle];
        Pose place = car.Pose;
        foreach ((double right, double up) in ((double, double)[])[(-0.35, 2.1), (0.35, 2.7)])
        {
            car.Pose = new Pose(new Vector3D(100 + right, 200, up - 0.4), Axes.Identity);
            driver.Press(Keys.NumPad2);
        }

        car.Pose = place;
        driver.Press(Keys.NumPad3);
        driver.Press(Keys.NumPad3);
        Keep(driver);
        Assert.Contains("in use from the next harvest on", driver.Game.Notifications[^1], StringComparison.Ordinal);
        driver.Tick(100);
        driver.Press(Keys.J);
        driver.WaitForDisk();
        TakeOne(driver);

        string[] labels = LabelsIn(Assert.Single(Directory.GetDirectories(driver.Output, "session*")));
        Assert.NotEmpty(labels);
        Assert.All(labels, label => Assert.DoesNotContain("ONE WAY", label, StringComparison.Ordinal));
        Assert.Contains(
            "ONE WAY",
            Assert.Single(LabelsIn(Assert.Single(Directory.GetDirectories(driver.Output, "singles*")))),
            StringComparison.Ordinal
        );
    }

    [Fact]
    public void Nothing_to_mark_or_keep_is_reported()
    {
        using var driver = new ScriptDriver(Names);
        driver.Press(Keys.Y);
        Assert.Contains("Mark two opposite corners", driver.Game.Notifications[^1], StringComparison.Ordinal);
        driver.Press(Keys.NumPad2);
        Assert.Contains("no prop in the middle of the screen", driver.Game.Notifications[^1], StringComparison.Ordinal);

        // A car is no prop.
        driver.Game.Add(
            new GameEntity
            {
                Pool = PoolKind.Vehicles,
                Name = "asea",
                Pose = new Pose(new Vector3D(-2, 20, 31), Axes.Identity),
            }
        );
        driver.Game.Notifications.Clear();
        driver.Clock.Milliseconds += 10_000;
        driver.Press(Keys.NumPad2);
        driver.Press(Keys.Y);
        Assert.Contains("Mark two opposite corners", driver.Game.Notifications[^1], StringComparison.Ordinal);
    }

    [Fact]
    public void Model_marked_by_hand_is_not_overwritten_by_a_survey()
    {
        using ScriptDriver driver = BeforeSign(Names);
        Mark(driver, -0.35, 2.1);
        Mark(driver, 0.35, 2.7);
        Keep(driver);

        Assert.True(new SurveyFolder(Folder(driver)).IsDone(Sign));
    }

    [Fact]
    public void Unknown_nearby_models_are_listed_with_their_positions()
    {
        using ScriptDriver driver = BeforeSign(Names);
        driver.Game.Add(
            new GameEntity
            {
                Pool = PoolKind.Props,
                Name = "prop_bench_01a",
                Pose = new Pose(new Vector3D(90, 200, 0), Axes.Identity),
            }
        );
        driver.Game.Add(
            new GameEntity
            {
                Pool = PoolKind.Props,
                Name = "prop_far_away",
                Pose = new Pose(new Vector3D(900, 200, 0), Axes.Identity),
            }
        );
        Look(driver, 100, 2.1);
        driver.Press(Keys.Divide);
        driver.WaitForDisk();

        Assert.Contains("2 models nearby without a face in any table", driver.Game.Notifications[^1], StringComparison.Ordinal);
        string file = Assert.Single(Directory.GetFiles(Folder(driver), "unknown-*.csv"));
        int bench = ModelHash.Of("prop_bench_01a");
        Assert.Equal(
            $"model,hash,class,x,y,z\n0x{bench:X8},{bench},other,90,200,0\n{Sign},{ModelHash.Of(Sign)},sign,100,200,0\n",
            File.ReadAllText(file)
        );
    }

    /// <summary>A sign at (100, 200, 0), 0.1 m thick, whose face the player sees from the south.</summary>
    private static ScriptDriver BeforeSign(string ini, string faces = "# none\n")
    {
        var driver = new ScriptDriver(ini, faces: faces);
        AddSign(driver, new Vector3D(100, 200, 0));
        return driver;
    }

    private static void AddSign(ScriptDriver driver, Vector3D place) =>
        driver.Game.Add(
            new GameEntity
            {
                Pool = PoolKind.Props,
                Name = Sign,
                Pose = new Pose(place, Axes.Identity),
                ModelMin = new Vector3D(-0.4, -0.05, 0),
                ModelMax = new Vector3D(0.4, 0.05, 2.8),
            }
        );

    private static void Mark(ScriptDriver driver, double right, double up)
    {
        Look(driver, 100 + right, up);
        driver.Press(Keys.NumPad2);
    }

    /// <summary>The game's own camera is 4 m behind the player and 1 m up, and looks as the player does: north.</summary>
    private static void Look(ScriptDriver driver, double east, double up) =>
        driver.Game.Entities[TestGame.Player].Pose = new Pose(new Vector3D(east, 190, up - 1), Axes.Identity);

    private static void MarkOneWay(ScriptDriver driver)
    {
        Mark(driver, -0.35, 2.1);
        Mark(driver, 0.35, 2.7);
        driver.Press(Keys.NumPad3);
        driver.Press(Keys.NumPad3);
    }

    private static void TakeOne(ScriptDriver driver)
    {
        driver.Press(Keys.K);
        driver.Tick(20);
        driver.WaitForDisk();
    }

    private static string[] LabelsIn(string session) => File.ReadAllLines(Path.Combine(session, "labels.jsonl"));

    private static void Keep(ScriptDriver driver)
    {
        // What was measured before is read on another thread.
        driver.WaitForDisk();
        driver.Press(Keys.Y);
        driver.WaitForDisk();
        Assert.Contains("Saved: face", driver.Game.Notifications[^1], StringComparison.Ordinal);
    }

    private static string Folder(ScriptDriver driver) => Path.Combine(driver.Output, "spaces");

    private static IEnumerable<ModelFace> Rows(ScriptDriver driver) => new SurveyFolder(Folder(driver)).Table.Of(Sign);

    private static Vector2D Middle(Box2D box) => new((box.XMin + box.XMax) / 2, (box.YMin + box.YMax) / 2);

    private static void AssertNear(Vector3D expected, Vector3D actual)
    {
        // A table holds millimetres.
        const double millimetre = 1e-3;
        Assert.InRange((expected - actual).Length, 0, millimetre);
    }
}
