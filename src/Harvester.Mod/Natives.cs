using System;
using GTA.Math;
using GTA.Native;
using Harvester.Geometry;

namespace Harvester.Mod;

/// <summary>
/// The game's native functions, and those about entities that several adapters call. Natives hold on every build that ScriptHookV
/// serves, where the API's own members that read memory do not.
/// </summary>
internal static class Natives
{
    /// <summary>The game's order of rotations: roll, then pitch, then yaw.</summary>
    public const int RotationOrder = 2;

    /// <summary>Calls so far, over the life of the script's domain.</summary>
    public static long Calls { get; private set; }

    public static int PlayerPed() => Call<int>(Hash.PLAYER_PED_ID);

    public static bool EntityExists(int entity) => Call<bool>(Hash.DOES_ENTITY_EXIST, entity);

    public static bool ModelExists(int model) => Call<bool>(Hash.IS_MODEL_IN_CDIMAGE, model);

    public static Vector3D EntityPosition(int entity) => ToWorld(Call<Vector3>(Hash.GET_ENTITY_COORDS, entity, false));

    public static int EntityModel(int entity) => Call<int>(Hash.GET_ENTITY_MODEL, entity);

    public static Vector3D EntityVelocity(int entity) => ToWorld(Call<Vector3>(Hash.GET_ENTITY_VELOCITY, entity));

    /// <summary>Where an entity is and how it is turned, without a scale of its matrix.</summary>
    /// <exception cref="InvalidOperationException">Its matrix is sheared or mirrored, or the entity is gone.</exception>
    public static Pose EntityPose(int entity) => EntityMatrix(entity)?.Pose
        ?? throw new InvalidOperationException("The game gave a matrix that is sheared or mirrored, perhaps by another mod. Use another vehicle.");

    /// <summary>
    /// The four vectors of an entity's matrix in one call, so that they belong together; null when no rotation and scale make it.
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

    /// <summary>Whether a ped is a person, and not the player.</summary>
    public static bool IsPerson(int ped) => ped != PlayerPed() && Call<bool>(Hash.IS_PED_HUMAN, ped);

    public static bool IsInVehicle(int ped) => Call<bool>(Hash.IS_PED_IN_ANY_VEHICLE, ped, false);

    /// <summary>The vehicle that a ped sits in, or 0.</summary>
    public static int VehicleOf(int ped) =>
        IsInVehicle(ped) ? Call<int>(Hash.GET_VEHICLE_PED_IS_IN, ped, false) : 0;

    /// <summary>Puts a vehicle onto all its wheels.</summary>
    public static void PlaceOnGround(int vehicle)
    {
        // What the game's own scripts pass.
        const float distance = 5;
        Call(Hash.SET_VEHICLE_ON_GROUND_PROPERLY, vehicle, distance);
    }

    /// <summary>Deletes an entity by the native for its kind; the game deletes only what belongs to a script.</summary>
    public static void Delete(int entity, Hash native)
    {
        Call(Hash.SET_ENTITY_AS_MISSION_ENTITY, entity, false, true);
        using var handle = NativeOutput.Holding(entity);
        Call(native, handle);
    }

    // An array on purpose: the API's overloads by number of arguments are not the same in all versions.
    public static T Call<T>(Hash native, params InputArgument[] arguments)
    {
        Calls++;
        return Function.Call<T>(native, arguments);
    }

    public static void Call(Hash native, params InputArgument[] arguments)
    {
        Calls++;
        Function.Call(native, arguments);
    }

    public static Vector3D ToWorld(Vector3 vector) => new(vector.X, vector.Y, vector.Z);
}
