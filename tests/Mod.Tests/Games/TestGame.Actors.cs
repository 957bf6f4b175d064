using GTA.Hosting;
using GTA.Native;
using Harvester.Geometry;
using Harvester.Mod.Tests.Games.Natives;
using Harvester.Sessions.Scenes;

namespace Harvester.Mod.Tests.Games;

/// <summary>The natives by which staged actors are made and driven.</summary>
internal sealed partial class TestGame
{
    public const string Walker = "a_m_y_business_01";
    private const int Civilian = 4;

    /// <summary>Whether the camera sees every place.</summary>
    public bool SeesEverything { get; set; }

    public bool PedPoolIsFull { get; set; }

    /// <summary>The last places to which tasks lead, with the speed or gait, by the handle of the ped.</summary>
    public Dictionary<int, (Vector3D Place, double Speed, int Style)> Tasks { get; } = [];

    /// <summary>The peds that a task lets brake.</summary>
    public HashSet<int> Braking { get; } = [];

    /// <summary>The open doors and the indicators that shine, as the vehicle's handle and their numbers.</summary>
    public HashSet<(int Vehicle, int Number)> OpenDoors { get; } = [];

    public HashSet<(int Vehicle, int Number)> Indicators { get; } = [];

    /// <summary>The peds that keep to their tasks.</summary>
    public HashSet<int> Calmed { get; } = [];

    private static bool IsPedModel(int model) => model == ModelHash.Of(Walker);

    private void AddActorNatives()
    {
        _natives[Hash.IS_SPHERE_VISIBLE] = a =>
        {
            Assert.True((float)a[3] > 0);
            return SeesEverything;
        };
        _natives[Hash.CREATE_PED] = a => CreatePed((int)a[0], (int)a[1], ToWorld(a[2], a[3], a[4]), (float)a[5], 0);
        _natives[Hash.CREATE_PED_INSIDE_VEHICLE] = a =>
        {
            Assert.Equal(-1, (int)a[3]);
            GameEntity vehicle = Entities[(int)a[0]];
            float heading = (float)Angles.HeadingDegrees(vehicle.Pose.Axes.Forward);
            return CreatePed((int)a[1], (int)a[2], vehicle.Pose.Position, heading, (int)a[0]);
        };
        Do(Hash.SET_BLOCKING_OF_NON_TEMPORARY_EVENTS, a => Calmed.Add((int)a[0]));
        Do(
            Hash.DELETE_PED,
            a =>
            {
                int handle = ((NativeAddress)a[0]).Integer;
                Remove(handle);
                Tasks.Remove(handle);
                Write(a[0], 0);
            }
        );
        Do(Hash.SET_VEHICLE_FORWARD_SPEED, a => Entities[(int)a[0]].Velocity = Entities[(int)a[0]].Pose.Axes.Forward * (float)a[1]);
        Do(
            Hash.TASK_VEHICLE_DRIVE_TO_COORD,
            a =>
            {
                Assert.Equal((int)a[1], VehicleOf((int)a[0]));
                Assert.Equal(Entities[(int)a[1]].Model, (int)a[7]);
                Braking.Remove((int)a[0]);
                Tasks[(int)a[0]] = (ToWorld(a[2], a[3], a[4]), (float)a[5], (int)a[8]);
            }
        );
        Do(Hash.SET_DRIVE_TASK_CRUISE_SPEED, a => Tasks[(int)a[0]] = Tasks[(int)a[0]] with { Speed = (float)a[1] });
        Do(
            Hash.TASK_VEHICLE_TEMP_ACTION,
            a =>
            {
                const int brakesHard = 27;
                Assert.Equal(brakesHard, (int)a[2]);
                Braking.Add((int)a[0]);
            }
        );
        Do(Hash.TASK_GO_STRAIGHT_TO_COORD, a => Tasks[(int)a[0]] = (ToWorld(a[1], a[2], a[3]), (float)a[4], 0));
        Do(Hash.SET_VEHICLE_DOOR_OPEN, a => OpenDoors.Add(((int)a[0], (int)a[1])));
        Do(Hash.SET_VEHICLE_DOOR_SHUT, a => OpenDoors.Remove(((int)a[0], (int)a[1])));
        Do(
            Hash.SET_VEHICLE_INDICATOR_LIGHTS,
            a =>
            {
                _ = (bool)a[2] ? Indicators.Add(((int)a[0], (int)a[1])) : Indicators.Remove(((int)a[0], (int)a[1]));
            }
        );
    }

    private int CreatePed(int type, int model, Vector3D place, float headingDegrees, int vehicle)
    {
        Assert.Equal(Civilian, type);
        if (PedPoolIsFull)
        {
            return 0;
        }

        return HasLoaded(model) && IsPedModel(model)
            ? Make(
                new GameEntity
                {
                    Pool = PoolKind.Peds,
                    Name = Walker,
                    Pose = new Pose(place, Axes.FromHeading(headingDegrees)),
                    Vehicle = vehicle,
                }
            )
            : throw new InvalidOperationException("A ped was made of a model that is not loaded.");
    }
}
