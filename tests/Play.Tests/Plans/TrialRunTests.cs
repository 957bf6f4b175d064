using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Play.Plans;
using Harvester.Sessions.Plans;
using Harvester.Sessions.Rigs;

namespace Harvester.Play.Tests.Plans;

public sealed class TrialRunTests : IDisposable
{
    private const string AtPoint = """
        {"name":"p","places":[{"name":"a","x":100,"y":200,"headingDegrees":270}],"weathers":["rain"],"hours":["21:30"],"frames":5,"hz":2,
        "traffic":0.5,"pedestrians":2,"parked":0,"cameras":[{"name":"c","width":320,"height":240,"verticalFovDegrees":60}]}
        """;

    /// <summary>More than all waits of an attempt together, in ticks of 50 ms.</summary>
    private const int MaxTicks = 10_000;
    private readonly string _root = Directory.CreateTempSubdirectory("trial-run").FullName;
    private readonly TrialWorld _world = new();

    public void Dispose() => Directory.Delete(_root, recursive: true);

    [Fact]
    public void Trial_takes_its_frames_under_its_conditions()
    {
        TrialRun run = Run();
        UntilPhase(run, TrialPhase.Driving);

        Assert.Equal(("rain", new TimeSpan(21, 30, 0)), (_world.Weather, _world.TimeOfDay));
        Assert.Equal(
            (100.0, 200.0, TrialWorld.GroundMetres + 1, 270.0),
            (_world.Position.X, _world.Position.Y, _world.Position.Z, _world.HeadingDegrees)
        );
        Assert.Equal(
            (320, 240, 2.0, 5),
            (
                _world.HarvestedWith!.Image.Width,
                _world.HarvestedWith.Image.Height,
                _world.HarvestedWith.RateHz,
                _world.HarvestedWith.MaxFrames
            )
        );
        Assert.True(_world.IsProtected);
        UntilOver(run);

        Assert.Equal((0.5, 2.0, 0.0), _world.Densities);
        Assert.Equal(new TrialEnding(5, null), run.Ending);
        AssertGivenBack();
    }

    [Fact]
    public void Trial_has_its_own_camera_though_the_settings_have_a_rig()
    {
        var left = new RigCamera("left", new Pose(Vector3D.Zero, Axes.Identity), 50, new ImageSize(64, 48), Lens.Ideal);
        _world.Rig = new Rig("pair", Vector3D.Zero, [left, left with { Name = "right" }], []);
        UntilPhase(Run(), TrialPhase.Driving);

        Assert.Equal((1, 320), (_world.HarvestedWith!.ViewsPerMoment, _world.HarvestedWith.Image.Width));
    }

    [Fact]
    public void Place_is_waited_for_with_the_car_held()
    {
        (_world.Ground, _world.IsSceneLoaded, _world.IsCollisionLoaded) = (null, false, false);
        TrialRun run = Run();
        Tick(run, 100);
        Assert.Equal((TrialPhase.Loading, true), (run.Phase, _world.IsHeld));
        _world.Ground = TrialWorld.GroundMetres;
        Tick(run, 100);
        Assert.Equal(TrialPhase.Loading, run.Phase);
        _world.IsSceneLoaded = true;
        Tick(run, 100);
        Assert.Equal(TrialPhase.Loading, run.Phase);
        _world.IsCollisionLoaded = true;
        Tick(run, 1);

        Assert.Equal((TrialPhase.Settling, false, false), (run.Phase, _world.IsHeld, _world.IsLoading));
    }

    [Fact]
    public void Place_that_never_loads_ends_the_attempt()
    {
        _world.IsCollisionLoaded = false;

        Assert.Equal("The place did not load within 30 s.", ReasonOf(Run()));
    }

    [Fact]
    public void Frames_wait_for_a_settled_picture()
    {
        _world.IsPictureRestless = true;
        TrialRun run = Run();
        UntilPhase(run, TrialPhase.Settling);
        double began = _world.Milliseconds;
        Tick(run, 100);
        Assert.Equal(TrialPhase.Settling, run.Phase);
        _world.IsPictureRestless = false;
        UntilPhase(run, TrialPhase.Driving);

        // Two comparisons of pictures half a second apart, after five restless seconds.
        const double tick = 50;
        Assert.InRange(_world.Milliseconds - began, 6_000, 6_500 + (2 * tick));
        Assert.Empty(_world.Logged);
    }

    [Fact]
    public void Picture_that_never_settles_is_logged_and_taken()
    {
        _world.IsPictureRestless = true;
        TrialRun run = Run();
        UntilOver(run);

        Assert.Null(run.Ending!.Reason);
        Assert.Equal("a_rain_2130_c_001: the picture has not settled; frames are taken all the same.", Assert.Single(_world.Logged));
    }

    [Theory]
    [InlineData(Mishap.Dead, "The player died.")]
    [InlineData(Mishap.CutScene, "A cut scene began.")]
    [InlineData(Mishap.PlayerSwitch, "The game changed to another character.")]
    [InlineData(Mishap.Wanted, "The player was wanted.")]
    [InlineData(Mishap.OnFoot, "The player left the vehicle.")]
    [InlineData(Mishap.InWater, "The vehicle was in water.")]
    [InlineData(Mishap.UpsideDown, "The vehicle lay on its roof.")]
    public void Mishap_ends_the_attempt_with_its_reason(Mishap mishap, string reason)
    {
        TrialRun run = Run();
        UntilPhase(run, TrialPhase.Driving);
        Tick(run, 20);
        _world.Situation = mishap switch
        {
            Mishap.Dead => _world.Situation with { IsDead = true },
            Mishap.CutScene => _world.Situation with { IsInCutScene = true },
            Mishap.PlayerSwitch => _world.Situation with { IsSwitching = true },
            Mishap.Wanted => _world.Situation with { WantedLevel = 2 },
            Mishap.OnFoot => _world.Situation with { IsInVehicle = false },
            Mishap.InWater => _world.Situation with { IsInWater = true },
            _ => _world.Situation with { IsUpsideDown = true },
        };
        Tick(run, 3);

        Assert.Equal((TrialPhase.Over, reason), (run.Phase, run.Ending!.Reason));
        Assert.False(_world.IsOn);
        AssertGivenBack();
    }

    [Fact]
    public void Car_that_does_not_move_is_stuck_after_a_minute()
    {
        _world.Moves = false;
        TrialRun run = Run(AtPoint.Replace("\"frames\":5", "\"frames\":5000", StringComparison.Ordinal));
        UntilPhase(run, TrialPhase.Driving);
        double began = _world.Milliseconds;

        Assert.Equal("The vehicle was stuck: it moved less than 5 m in 60 s.", ReasonOf(run));
        Assert.InRange(_world.Milliseconds - began, 60_000, 61_000);
    }

    [Fact]
    public void Wanted_level_and_cut_scene_are_corrected()
    {
        TrialRun run = Run();
        _world.Situation = _world.Situation with { WantedLevel = 3, IsInCutScene = true };
        Tick(run, 2);

        Assert.Equal(["clear wanted", "end cut scene"], _world.Done);
        UntilOver(run);
        Assert.Null(run.Ending!.Reason);
    }

    [Fact]
    public void Player_who_died_is_put_back_into_the_car()
    {
        TrialRun first = Run();
        UntilPhase(first, TrialPhase.Driving);
        _world.Situation = new GameSituation { IsDead = true };
        _world.PlayersVehicle = 0;
        UntilOver(first);
        TrialRun second = Run();
        Tick(second, 50);
        Assert.Equal(TrialPhase.Boarding, second.Phase);
        _world.Situation = new GameSituation();
        UntilOver(second);

        Assert.Null(second.Ending!.Reason);
        Assert.Equal([$"seat in {TrialWorld.Car}"], _world.Done);
    }

    [Fact]
    public void Player_without_any_car_gets_one()
    {
        (_world.PlayersVehicle, _world.Situation) = (0, new GameSituation());
        TrialRun run = Run();
        UntilOver(run);

        Assert.Null(run.Ending!.Reason);
        Assert.Equal([$"prepare {TrialWorld.Car + 1}", $"seat in {TrialWorld.Car + 1}"], _world.Done);
        _world.Surroundings.Car.Remove();
        Assert.Equal([TrialWorld.Car], _world.Vehicles);
    }

    [Fact]
    public void Cut_scene_without_end_ends_the_wait()
    {
        (_world.AcceptsCorrections, _world.Situation) = (false, new GameSituation { IsInCutScene = true });

        Assert.Equal("A cut scene began.", ReasonOf(Run()));
    }

    [Fact]
    public void Harvest_that_fails_ends_the_attempt_with_its_fault()
    {
        TrialRun run = Run();
        UntilPhase(run, TrialPhase.Driving);
        Tick(run, 15);
        _world.Break("The disk is full.");

        Assert.Equal("The disk is full.", ReasonOf(run));
    }

    [Fact]
    public void Harvest_that_the_player_ends_is_no_whole_trial()
    {
        TrialRun run = Run();
        UntilPhase(run, TrialPhase.Driving);
        Tick(run, 15);
        _world.End();

        Assert.Equal("The harvest ended after 1 frames.", ReasonOf(run));
    }

    [Fact]
    public void Harvest_that_cannot_begin_ends_the_attempt()
    {
        _world.BeginsHarvests = false;

        Assert.StartsWith("The harvest did not begin", ReasonOf(Run()), StringComparison.Ordinal);
    }

    [Fact]
    public void Drive_ends_after_the_metres_of_its_place()
    {
        TrialRun run = Run("""{"name":"p","places":[{"name":"a","x":0,"y":0,"headingDegrees":0,"metres":20}],"frames":5000}""");
        UntilPhase(run, TrialPhase.Driving);
        double began = _world.Milliseconds;
        UntilOver(run);

        // 20 m at 10 m/s are 2 s.
        Assert.InRange(_world.Milliseconds - began, 1_950, 2_250);
        Assert.Null(run.Ending!.Reason);
    }

    [Fact]
    public void Path_is_driven_to_its_end()
    {
        TrialRun run = Run("""{"name":"p","places":[{"name":"a","path":[[0,0],[50,0]]}],"frames":5000}""");
        UntilOver(run);

        Assert.Null(run.Ending!.Reason);
        Assert.InRange(_world.Position.X, 46, 50);
        Assert.Equal(-90, _world.HeadingDegrees);
    }

    [Fact]
    public void Car_far_from_its_path_is_lost()
    {
        TrialRun run = Run("""{"name":"p","places":[{"name":"a","path":[[0,0],[50,0]]}],"frames":5000}""");
        UntilPhase(run, TrialPhase.Driving);
        _world.Place(TrialWorld.Car, new Vector3D(0, 40, 31), 0);

        Assert.Equal("The vehicle left its path.", ReasonOf(run));
    }

    [Fact]
    public void Session_is_waited_for_before_the_attempt_is_over()
    {
        TrialRun run = Run();
        _world.IsBusy = true;
        UntilPhase(run, TrialPhase.Writing);
        Tick(run, 100);
        Assert.Null(run.Ending);
        _world.IsBusy = false;
        Tick(run, 1);

        Assert.Equal(new TrialEnding(5, null), run.Ending);
    }

    [Fact]
    public void Stopped_attempt_gives_everything_back()
    {
        TrialRun run = Run();
        UntilPhase(run, TrialPhase.Driving);
        run.Stop("Stopped.");
        run.Stop("Again.");
        Tick(run, 1);

        Assert.Equal("Stopped.", run.Ending!.Reason);
        AssertGivenBack();
        _world.Surroundings.Grip.GiveAllBack();
        Assert.Null(_world.Weather);
    }

    private TrialRun Run(string text = AtPoint)
    {
        Plan plan = PlanParser.Read(text).Plan!;
        Trial trial = TrialList.Of(plan, plan.Places)[0];
        return new TrialRun(_world.Surroundings, plan, trial, Path.Combine(_root, trial.Id), rig: null);
    }

    private void Tick(TrialRun run, int count)
    {
        for (int i = 0; i < count; i++)
        {
            _world.Pass();
            run.Tick();
        }
    }

    private void UntilPhase(TrialRun run, TrialPhase phase)
    {
        for (int i = 0; run.Phase != phase; i++)
        {
            Assert.True(i < MaxTicks && run.Phase != TrialPhase.Over, $"{phase} never comes: {run.Phase}, {run.Ending}");
            Tick(run, 1);
        }
    }

    private void UntilOver(TrialRun run) => UntilEnd(run);

    private string? ReasonOf(TrialRun run)
    {
        UntilEnd(run);
        AssertGivenBack();
        return run.Ending!.Reason;
    }

    private void UntilEnd(TrialRun run)
    {
        for (int i = 0; run.Ending is null; i++)
        {
            Assert.True(i < MaxTicks, $"The end never comes: {run.Phase}");
            Tick(run, 1);
        }
    }

    private void AssertGivenBack() =>
        Assert.Equal((false, false, false, false), (_world.IsHeld, _world.IsProtected, _world.IsLoading, _world.IsOn));
}
