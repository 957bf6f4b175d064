using GTA.Native;
using Harvester.Geometry;

namespace Harvester.Mod.Tests.Games;

/// <summary>The natives by which the trials of a plan are run.</summary>
internal sealed partial class TestGame
{
    /// <summary>The game's number of the player, which is not that of its body.</summary>
    private const int PlayerNumber = 3;

    private const int TicksToLoadAScene = 5;
    private const float GroundMetres = 0;
    private int _sceneBeganAt;

    public bool IsInCutScene { get; set; }

    public int WantedLevel { get; set; }

    /// <summary>Whether a script keeps a scene loaded.</summary>
    public bool IsSceneHeld { get; private set; }

    /// <summary>Whether a script has made the player invulnerable.</summary>
    public bool IsPlayerInvincible { get; private set; }

    /// <summary>Whether a script lets the police ignore the player.</summary>
    public bool IsIgnoredByPolice { get; private set; }

    /// <summary>Whether the game's own driver drives for the player.</summary>
    public bool IsDrivenByTask { get; private set; }

    private void AddTrialNatives()
    {
        _natives[Hash.PLAYER_ID] = _ => PlayerNumber;
        _natives[Hash.IS_PLAYER_DEAD] = a => OfPlayer(a, false);
        _natives[Hash.IS_CUTSCENE_ACTIVE] = _ => IsInCutScene;
        Do(Hash.STOP_CUTSCENE_IMMEDIATELY, _ => IsInCutScene = false);
        _natives[Hash.IS_PLAYER_SWITCH_IN_PROGRESS] = _ => false;
        _natives[Hash.GET_PLAYER_WANTED_LEVEL] = a => OfPlayer(a, WantedLevel);
        Do(Hash.CLEAR_PLAYER_WANTED_LEVEL, a => WantedLevel = OfPlayer(a, 0));
        Do(Hash.SET_PLAYER_INVINCIBLE, a => IsPlayerInvincible = OfPlayer(a, (bool)a[1]));
        Do(Hash.SET_POLICE_IGNORE_PLAYER, a => IsIgnoredByPolice = OfPlayer(a, (bool)a[1]));
        _natives[Hash.IS_ENTITY_IN_WATER] = _ => false;
        _natives[Hash.IS_ENTITY_UPSIDEDOWN] = a => Entities.TryGetValue((int)a[0], out GameEntity? entity) && entity.Pose.Axes.Up.Z < 0;
        Do(
            Hash.SET_PED_INTO_VEHICLE,
            a =>
            {
                Assert.Equal((Player, -1), ((int)a[0], (int)a[2]));
                PlayersVehicle = Entities.ContainsKey((int)a[1]) ? (int)a[1] : 0;
            }
        );
        _natives[Hash.NEW_LOAD_SCENE_START_SPHERE] = _ =>
        {
            (IsSceneHeld, _sceneBeganAt) = (true, Frame);
            return true;
        };
        _natives[Hash.IS_NEW_LOAD_SCENE_LOADED] = _ => IsSceneHeld && Frame - _sceneBeganAt >= TicksToLoadAScene;
        Do(Hash.NEW_LOAD_SCENE_STOP, _ => IsSceneHeld = false);
        Do(Hash.REQUEST_COLLISION_AT_COORD, _ => { });
        _natives[Hash.HAS_COLLISION_LOADED_AROUND_ENTITY] = _ => true;
        _natives[Hash.GET_GROUND_Z_FOR_3D_COORD] = a =>
        {
            Write(a[3], GroundMetres);
            return true;
        };
        Do(Hash.SET_VEHICLE_DENSITY_MULTIPLIER_THIS_FRAME, _ => { });
        Do(Hash.SET_RANDOM_VEHICLE_DENSITY_MULTIPLIER_THIS_FRAME, _ => { });
        Do(Hash.SET_PARKED_VEHICLE_DENSITY_MULTIPLIER_THIS_FRAME, _ => { });
        Do(Hash.SET_PED_DENSITY_MULTIPLIER_THIS_FRAME, _ => { });
        Do(Hash.SET_SCENARIO_PED_DENSITY_MULTIPLIER_THIS_FRAME, _ => { });
        Do(
            Hash.TASK_VEHICLE_DRIVE_WANDER,
            a =>
            {
                Assert.Equal((Player, PlayersVehicle), ((int)a[0], (int)a[1]));
                IsDrivenByTask = true;
            }
        );
        Do(Hash.CLEAR_PED_TASKS, _ => IsDrivenByTask = false);
    }

    private static T OfPlayer<T>(object[] arguments, T value)
    {
        Assert.Equal(PlayerNumber, (int)arguments[0]);
        return value;
    }
}
