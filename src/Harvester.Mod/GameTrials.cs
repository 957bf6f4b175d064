using GTA.Native;
using Harvester.Geometry;
using Harvester.Play.Plans;

namespace Harvester.Mod;

/// <summary>What running trials needs of the game, by its natives.</summary>
internal sealed class GameTrials : ITrialGame
{
    private const float SceneRadiusMetres = 200;
    private const int DriversSeat = -1;

    /// <summary>The game's number of a style that stops for vehicles, people and lights, and steers round what stands.</summary>
    private const int LawfulStyle = 786603;

    /// <inheritdoc/>
    public bool IsSceneLoaded => Natives.Call<bool>(Hash.IS_NEW_LOAD_SCENE_LOADED);

    /// <inheritdoc/>
    public GameSituation Read(int vehicle)
    {
        bool exists = vehicle != 0 && Natives.EntityExists(vehicle);
        return new GameSituation
        {
            IsDead = Natives.Call<bool>(Hash.IS_PLAYER_DEAD, Player()),
            IsInCutScene = Natives.Call<bool>(Hash.IS_CUTSCENE_ACTIVE),
            IsSwitching = Natives.Call<bool>(Hash.IS_PLAYER_SWITCH_IN_PROGRESS),
            WantedLevel = Natives.Call<int>(Hash.GET_PLAYER_WANTED_LEVEL, Player()),
            IsInVehicle = exists && Natives.VehicleOf(Natives.PlayerPed()) == vehicle,
            IsInWater = exists && Natives.Call<bool>(Hash.IS_ENTITY_IN_WATER, vehicle),
            IsUpsideDown = exists && Natives.Call<bool>(Hash.IS_ENTITY_UPSIDEDOWN, vehicle),
            Position = exists ? Natives.EntityPosition(vehicle) : Vector3D.Zero,
        };
    }

    /// <inheritdoc/>
    public void Protect(int vehicle) => SetProtection(vehicle, true);

    /// <inheritdoc/>
    public void Unprotect(int vehicle) => SetProtection(vehicle, false);

    /// <inheritdoc/>
    public void ClearWanted() => Natives.Call(Hash.CLEAR_PLAYER_WANTED_LEVEL, Player());

    /// <inheritdoc/>
    public void EndCutScene() => Natives.Call(Hash.STOP_CUTSCENE_IMMEDIATELY);

    /// <inheritdoc/>
    public void EnterVehicle(int vehicle) => Natives.Call(Hash.SET_PED_INTO_VEHICLE, Natives.PlayerPed(), vehicle, DriversSeat);

    /// <inheritdoc/>
    public void Repair(int vehicle) => Natives.Call(Hash.SET_VEHICLE_FIXED, vehicle);

    /// <inheritdoc/>
    public void BeginLoading(Vector3D place) =>
        Natives.Call<bool>(Hash.NEW_LOAD_SCENE_START_SPHERE, (float)place.X, (float)place.Y, (float)place.Z, SceneRadiusMetres, 0);

    /// <inheritdoc/>
    public void EndLoading() => Natives.Call(Hash.NEW_LOAD_SCENE_STOP);

    /// <inheritdoc/>
    public void RequestCollision(Vector3D place) =>
        Natives.Call(Hash.REQUEST_COLLISION_AT_COORD, (float)place.X, (float)place.Y, (float)place.Z);

    /// <inheritdoc/>
    public bool HasCollision(int vehicle) => Natives.Call<bool>(Hash.HAS_COLLISION_LOADED_AROUND_ENTITY, vehicle);

    /// <inheritdoc/>
    public double? GroundBelow(Vector3D place)
    {
        using var height = new NativeOutput();
        const bool isWaterGround = false;
        return Natives.Call<bool>(
            Hash.GET_GROUND_Z_FOR_3D_COORD,
            (float)place.X,
            (float)place.Y,
            (float)place.Z,
            height,
            isWaterGround,
            false
        )
            ? height.Single
            : null;
    }

    /// <inheritdoc/>
    public void Hold(int vehicle, Vector3D? place)
    {
        if (!Natives.EntityExists(vehicle))
        {
            return;
        }

        Natives.Call(Hash.FREEZE_ENTITY_POSITION, vehicle, place is not null);
        if (place is { } there)
        {
            Natives.Call(Hash.SET_ENTITY_COORDS_NO_OFFSET, vehicle, (float)there.X, (float)there.Y, (float)there.Z, false, false, false);
        }
    }

    /// <inheritdoc/>
    public void SetDensities(double traffic, double pedestrians, double parked)
    {
        Natives.Call(Hash.SET_VEHICLE_DENSITY_MULTIPLIER_THIS_FRAME, (float)traffic);
        Natives.Call(Hash.SET_RANDOM_VEHICLE_DENSITY_MULTIPLIER_THIS_FRAME, (float)traffic);
        Natives.Call(Hash.SET_PARKED_VEHICLE_DENSITY_MULTIPLIER_THIS_FRAME, (float)parked);
        Natives.Call(Hash.SET_PED_DENSITY_MULTIPLIER_THIS_FRAME, (float)pedestrians);
        Natives.Call(Hash.SET_SCENARIO_PED_DENSITY_MULTIPLIER_THIS_FRAME, (float)pedestrians, (float)pedestrians);
    }

    /// <inheritdoc/>
    public void DriveAlongRoads(int vehicle, double speedMetresPerSecond) =>
        Natives.Call(Hash.TASK_VEHICLE_DRIVE_WANDER, Natives.PlayerPed(), vehicle, (float)speedMetresPerSecond, LawfulStyle);

    /// <inheritdoc/>
    public void StopDriving() => Natives.Call(Hash.CLEAR_PED_TASKS, Natives.PlayerPed());

    private static int Player() => Natives.Call<int>(Hash.PLAYER_ID);

    private static void SetProtection(int vehicle, bool isOn)
    {
        Natives.Call(Hash.SET_PLAYER_INVINCIBLE, Player(), isOn);
        Natives.Call(Hash.SET_POLICE_IGNORE_PLAYER, Player(), isOn);
        if (Natives.EntityExists(vehicle))
        {
            Natives.Call(Hash.SET_ENTITY_INVINCIBLE, vehicle, isOn);
        }
    }
}
