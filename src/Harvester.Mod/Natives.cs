using GTA.Math;
using GTA.Native;
using Harvester.Geometry;

namespace Harvester.Mod;

/// <summary>
/// The game's native functions, and those about entities that several adapters call. Natives work on every build that ScriptHookV supports;
/// the API's own members that read memory do not.
/// </summary>
internal static class Natives
{
    /// <summary>The game's order of rotations: roll, then pitch, then yaw.</summary>
    public const int RotationOrder = 2;

    /// <summary>Where calls go: the game, or what records or plays a tape.</summary>
    public static IGameApi Game { get; set; } = new ScriptApi();

    /// <summary>Number of calls so far, over the life of the script's domain.</summary>
    public static long Calls { get; private set; }

    public static int PlayerPed() => Call<int>(Hash.PLAYER_PED_ID);

    public static bool EntityExists(int entity) => Call<bool>(Hash.DOES_ENTITY_EXIST, entity);

    public static bool ModelExists(int model) => Call<bool>(Hash.IS_MODEL_IN_CDIMAGE, model);

    public static Vector3D EntityPosition(int entity) => ToWorld(Call<Vector3>(Hash.GET_ENTITY_COORDS, entity, false));

    public static int EntityModel(int entity) => Call<int>(Hash.GET_ENTITY_MODEL, entity);

    public static Vector3D EntityVelocity(int entity) => ToWorld(Call<Vector3>(Hash.GET_ENTITY_VELOCITY, entity));

    /// <summary>Position and orientation of an entity, without the scale of its matrix.</summary>
    /// <exception cref="InvalidOperationException">Its matrix is sheared or mirrored, or the entity no longer exists.</exception>
    public static Pose EntityPose(int entity) =>
        EntityMatrix(entity)?.Pose
        ?? throw new InvalidOperationException(
            "The game returned a sheared or mirrored matrix, possibly because of another mod. Use another vehicle."
        );

    /// <summary>
    /// The four vectors of an entity's matrix in one call, so that they are consistent; null if no rotation and scale give it.
    /// </summary>
    public static ScaledPose? EntityMatrix(int entity)
    {
        using var forward = new NativeOutput();
        using var right = new NativeOutput();
        using var up = new NativeOutput();
        using var position = new NativeOutput();
        Call(Hash.GET_ENTITY_MATRIX, entity, forward, right, up, position);
        return ScaledPose.FromMatrix(right.Vector, forward.Vector, up.Vector, position.Vector);
    }

    /// <summary>Whether a ped is a person, not an animal.</summary>
    public static bool IsHuman(int ped) => Call<bool>(Hash.IS_PED_HUMAN, ped);

    /// <summary>Whether a ped is a person other than the player.</summary>
    public static bool IsPerson(int ped) => ped != PlayerPed() && IsHuman(ped);

    public static bool IsInVehicle(int ped) => Call<bool>(Hash.IS_PED_IN_ANY_VEHICLE, ped, false);

    /// <summary>The vehicle that a ped sits in, or 0.</summary>
    public static int VehicleOf(int ped) => IsInVehicle(ped) ? VehicleSeating(ped) : 0;

    /// <summary>The vehicle of a ped that sits in one.</summary>
    public static int VehicleSeating(int ped) => Call<int>(Hash.GET_VEHICLE_PED_IS_IN, ped, false);

    /// <summary>The trailer that a vehicle pulls, or 0.</summary>
    public static int TrailerOf(int vehicle)
    {
        using var trailer = new NativeOutput();
        return Call<bool>(Hash.GET_VEHICLE_TRAILER_VEHICLE, vehicle, trailer) ? trailer.Integer : 0;
    }

    /// <summary>The entity to which another one is attached, or 0.</summary>
    public static int CarrierOf(int entity) => Call<int>(Hash.GET_ENTITY_ATTACHED_TO, entity);

    /// <summary>Places a vehicle on all its wheels.</summary>
    public static void PlaceOnGround(int vehicle)
    {
        // As in the game's own scripts.
        const float distance = 5;
        Call(Hash.SET_VEHICLE_ON_GROUND_PROPERLY, vehicle, distance);
    }

    /// <summary>Deletes an entity by the native for its kind; the game deletes only entities of scripts.</summary>
    public static void Delete(int entity, Hash native)
    {
        Call(Hash.SET_ENTITY_AS_MISSION_ENTITY, entity, false, true);
        using var handle = NativeOutput.Holding(entity);
        Call(native, handle);
    }

    // An array on purpose: the API's overloads by number of arguments differ between versions.
    public static T Call<T>(Hash native, params NativeArgument[] arguments)
    {
        Calls++;
        return Game.Call<T>(native, arguments);
    }

    public static void Call(Hash native, params NativeArgument[] arguments)
    {
        Calls++;
        Game.Call(native, arguments);
    }

    public static Vector3D ToWorld(Vector3 vector) => new(vector.X, vector.Y, vector.Z);
}
