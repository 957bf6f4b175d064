using GTA.Hosting;
using GTA.Native;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Mod.Tests.Games;

namespace Harvester.Mod.Tests;

/// <summary>Actors of scenarios, by the mod's own code on the stand-in of the game.</summary>
public sealed class ActorTests
{
    private const int EnoughTicks = 10;
    private static readonly StageActor Car = new(StageKind.Vehicle, TestGame.Adder, new Vector3D(100, 50, 30), 0, 8, 0);
    private static readonly StageActor Person = new(StageKind.Pedestrian, TestGame.Walker, new Vector3D(90, 50, 30), 180, 0, 0);

    /// <summary>North for 60 m, then east.</summary>
    private static readonly Vector3D[] Path = [new(100, 50, 30), new(100, 110, 30), new(160, 110, 30)];

    public static TheoryData<Hash> Natives =>
        [
            .. OwnNatives,
            Hash.REQUEST_MODEL,
            Hash.CREATE_VEHICLE,
            Hash.SET_VEHICLE_ON_GROUND_PROPERLY,
            Hash.GET_ENTITY_MATRIX,
            Hash.DELETE_VEHICLE,
            Hash.SET_MODEL_AS_NO_LONGER_NEEDED,
        ];

    /// <summary>The natives that only the stage calls.</summary>
    internal static IReadOnlyList<Hash> OwnNatives { get; } =
    [
        Hash.CREATE_PED,
        Hash.CREATE_PED_INSIDE_VEHICLE,
        Hash.DELETE_PED,
        Hash.IS_SPHERE_VISIBLE,
        Hash.SET_BLOCKING_OF_NON_TEMPORARY_EVENTS,
        Hash.SET_DRIVE_TASK_CRUISE_SPEED,
        Hash.SET_VEHICLE_DOOR_OPEN,
        Hash.SET_VEHICLE_DOOR_SHUT,
        Hash.SET_VEHICLE_FORWARD_SPEED,
        Hash.SET_VEHICLE_INDICATOR_LIGHTS,
        Hash.TASK_GO_STRAIGHT_TO_COORD,
        Hash.TASK_VEHICLE_DRIVE_TO_COORD,
        Hash.TASK_VEHICLE_TEMP_ACTION,
    ];

    /// <summary>A game in which the stage has used every native that it uses.</summary>
    internal static ScriptDriver Playing()
    {
        var driver = new ScriptDriver();
        var stage = new ScriptStage(driver);
        int car = stage.Spawn(Car).Handle;
        int person = stage.Spawn(Person).Handle;
        stage.Follow(car, new StageOrder(Path, 10, 2));
        stage.Follow(person, new StageOrder([new(90, 50, 30), new(90, 40, 30)], 1.4, 1));
        driver.Tick(EnoughTicks);
        stage.SetSpeed(car, 4, 3);
        stage.SetSpeed(car, 0, 3);
        stage.SetDoor(car, -1, true);
        stage.SetDoor(car, -1, false);
        stage.SetIndicators(car, StageIndicators.Left);
        stage.Remove(person);
        stage.Remove(car);
        return driver;
    }

    [Fact]
    public void Car_appears_when_streamed_in_and_drives_its_path_by_tasks()
    {
        using var driver = new ScriptDriver();
        var stage = new ScriptStage(driver);
        StageSpawn spawn = stage.Spawn(Car);
        Assert.Null(spawn.Reason);
        stage.Follow(spawn.Handle, new StageOrder(Path, 10, 2));
        Assert.Empty(driver.Game.Vehicles);
        Assert.Equal(Car.Ground, stage.StateOf(spawn.Handle)!.Pose.Position);

        driver.Tick(EnoughTicks);
        GameEntity car = Assert.Single(driver.Game.Vehicles);
        int ped = Assert.Single(driver.Game.Tasks).Key;
        Assert.True(car.IsOnGround);
        Assert.Equal(8, car.Velocity.Y, 6);
        Assert.Contains(ped, driver.Game.Calmed);
        Assert.Equal(driver.Game.HandleOf(car), driver.Game.Entities[ped].Vehicle);
        Assert.Equal(0, driver.Game.RequestedModels);

        // 10 m/s look 12 + 3 · 10 m ahead, and stop for vehicles, people and lights.
        (Vector3D place, double speed, int style) = driver.Game.Tasks[ped];
        Assert.Equal((new Vector3D(100, 92, 30), 10, 16_777_216 | 1 | 2 | 128), (place, speed, style));

        // Near the corner the next place is behind it; at the end of the path the driver brakes.
        Move(new Vector3D(100, 100, 30));
        Assert.Equal(new Vector3D(132, 110, 30), driver.Game.Tasks[ped].Place);
        Assert.False(stage.StateOf(spawn.Handle)!.IsAtEnd);
        Move(new Vector3D(159, 110, 30));
        Assert.True(stage.StateOf(spawn.Handle)!.IsAtEnd);
        Assert.Contains(ped, driver.Game.Braking);

        stage.Remove(spawn.Handle);
        Assert.Null(stage.StateOf(spawn.Handle));
        Assert.Empty(driver.Game.LeftBehind);

        void Move(Vector3D to)
        {
            car.Pose = car.Pose with { Position = to };
            driver.Tick();
        }
    }

    [Fact]
    public void Orders_change_speed_doors_and_indicators()
    {
        using var driver = new ScriptDriver();
        var stage = new ScriptStage(driver);
        int handle = stage.Spawn(Car).Handle;
        stage.Follow(handle, new StageOrder(Path, 10, 2) { IgnoresLights = true, IgnoresOthers = true });
        driver.Tick(EnoughTicks);
        int vehicle = driver.Game.HandleOf(driver.Game.Vehicles.Single());
        int ped = driver.Game.Tasks.Single().Key;
        Assert.Equal(16_777_216, driver.Game.Tasks[ped].Style);

        stage.SetSpeed(handle, 4, 3);
        Assert.Equal(4, driver.Game.Tasks[ped].Speed);
        stage.SetSpeed(handle, 0, 6);
        Assert.Contains(ped, driver.Game.Braking);
        driver.Tick();
        Assert.Contains(ped, driver.Game.Braking);
        stage.SetSpeed(handle, 5, 2);
        driver.Tick();
        Assert.DoesNotContain(ped, driver.Game.Braking);

        stage.SetDoor(handle, -1, true);
        stage.SetDoor(handle, 1, true);
        stage.SetDoor(handle, 1, false);
        Assert.Equal([(vehicle, 0)], driver.Game.OpenDoors);
        stage.SetIndicators(handle, StageIndicators.Hazard);
        Assert.Equal(2, driver.Game.Indicators.Count);
        stage.SetIndicators(handle, StageIndicators.Left);
        Assert.Equal([(vehicle, 1)], driver.Game.Indicators);
    }

    [Fact]
    public void Person_walks_and_runs_straight_to_the_places_of_the_path()
    {
        using var driver = new ScriptDriver();
        var stage = new ScriptStage(driver);
        int handle = stage.Spawn(Person).Handle;
        stage.Follow(handle, new StageOrder([new(90, 50, 30), new(90, 40, 30)], 1.4, 1));
        driver.Tick(EnoughTicks);
        Assert.Equal((new Vector3D(90, 40, 30), 1.0, 0), Assert.Single(driver.Game.Tasks).Value);
        stage.SetSpeed(handle, 3, 1);
        driver.Tick();
        Assert.Equal(2, Assert.Single(driver.Game.Tasks).Value.Speed);
    }

    [Fact]
    public void Actor_waits_a_moment_for_the_camera_to_look_elsewhere()
    {
        using var driver = new ScriptDriver(prepare: game => game.SeesEverything = true);
        _ = new ScriptStage(driver).Spawn(Person);
        driver.Tick(EnoughTicks);
        Assert.Single(driver.Game.LeftBehind, left => left.StartsWith("model", StringComparison.Ordinal));
        driver.Game.SeesEverything = false;
        driver.Tick();
        Assert.Contains($"entity {TestGame.Walker}", driver.Game.LeftBehind);
    }

    [Theory]
    [InlineData("no_such_model", StageKind.Vehicle)]
    [InlineData(TestGame.Walker, StageKind.Vehicle)]
    [InlineData("child", StageKind.Pedestrian)]
    public void Model_that_the_game_has_not_is_refused(string model, StageKind kind)
    {
        using var driver = new ScriptDriver();
        StageSpawn spawn = new ScriptStage(driver).Spawn(Car with { Kind = kind, Model = model });
        Assert.Equal((0, $"The game has no model '{model}'."), (spawn.Handle, spawn.Reason));
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Nothing_is_left_where_the_game_has_no_room(bool forPeds)
    {
        using var driver = new ScriptDriver(prepare: game => (game.PedPoolIsFull, game.VehiclePoolIsFull) = (forPeds, !forPeds));
        int handle = new ScriptStage(driver).Spawn(Car).Handle;
        driver.Tick(EnoughTicks);
        Assert.Null(new ScriptStage(driver).StateOf(handle));
        Assert.Empty(driver.Game.LeftBehind);
        Assert.Contains(driver.Game.Notifications, message => message.Contains("did not make the actor 'adder'", StringComparison.Ordinal));
    }

    /// <summary>Each native of the stage fails once, wherever it is called first; afterwards everything is removed.</summary>
    [Theory]
    [MemberData(nameof(Natives))]
    public void Nothing_is_left_after_a_fault_and_the_end_of_the_script(Hash failing)
    {
        using var driver = new ScriptDriver();
        int faults = 0;
        driver.Game.Fault = native => native == failing && faults++ == 0 ? new InvalidOperationException("A fault of the game.") : null;
        var stage = new ScriptStage(driver);
        int car = stage.Spawn(Car).Handle;
        stage.Follow(car, new StageOrder(Path, 10, 2));
        int person = stage.Spawn(Person).Handle;
        stage.Follow(person, new StageOrder([new(90, 50, 30), new(90, 40, 30)], 1.4, 1));
        driver.Tick(EnoughTicks);
        Try(() => stage.SetSpeed(car, 4, 3));
        driver.Tick();
        Try(() => stage.SetSpeed(car, 0, 3));
        driver.Tick();
        Try(() => stage.SetDoor(car, -1, true));
        Try(() => stage.SetDoor(car, -1, false));
        Try(() => stage.SetIndicators(car, StageIndicators.Left));
        driver.Tick();
        Try(stage.Stop);
        driver.Tick(EnoughTicks);
        Assert.True(faults > 0, $"{failing} is never called.");
        Assert.Empty(driver.Game.LeftBehind);

        // Who gives orders hears of the fault; the stage itself tries again in its next tick.
        static void Try(Action order)
        {
            try
            {
                order();
            }
            catch (InvalidOperationException) { }
        }
    }

    [Fact]
    public void Unloading_the_script_removes_all_actors()
    {
        using var driver = new ScriptDriver();
        var stage = new ScriptStage(driver);
        _ = stage.Spawn(Car);
        _ = stage.Spawn(Person);
        driver.Tick(EnoughTicks);
        Assert.Equal(3, driver.Game.LeftBehind.Count());
        driver.Reload();
        Assert.Empty(driver.Game.LeftBehind);
    }

    [Fact]
    public void Unloading_while_models_are_streamed_releases_them()
    {
        using var driver = new ScriptDriver();
        _ = new ScriptStage(driver).Spawn(Car);
        driver.Tick();
        Assert.NotEmpty(driver.Game.LeftBehind);
        driver.Reload();
        Assert.Empty(driver.Game.LeftBehind);
    }

    [Fact]
    public void Ego_is_driven_along_its_path_and_released()
    {
        using var driver = new ScriptDriver();
        driver.Game.PlayersVehicle = driver.Game.Add(
            new GameEntity
            {
                Pool = PoolKind.Vehicles,
                Name = TestGame.Adder,
                Pose = new Pose(Path[0], Axes.FromHeading(0)),
            }
        );
        new ScriptStage(driver).DriveEgo(new StageOrder(Path, 10, 2));
        driver.Tick();
        Assert.Equal(new Vector3D(100, 92, 30), Assert.Single(driver.Game.Tasks).Value.Place);
        new ScriptStage(driver).Stop();
        Assert.Contains(Hash.CLEAR_PED_TASKS, driver.Game.Calls);
    }
}
