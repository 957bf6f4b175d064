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

    public static int PlayerPed() => Call<int>(Hash.PLAYER_PED_ID);

    public static bool EntityExists(int entity) => Call<bool>(Hash.DOES_ENTITY_EXIST, entity);

    public static bool ModelExists(int model) => Call<bool>(Hash.IS_MODEL_IN_CDIMAGE, model);

    public static Vector3D EntityPosition(int entity) => ToWorld(Call<Vector3>(Hash.GET_ENTITY_COORDS, entity, false));

    public static int EntityModel(int entity) => Call<int>(Hash.GET_ENTITY_MODEL, entity);

    public static Vector3D EntityVelocity(int entity) => ToWorld(Call<Vector3>(Hash.GET_ENTITY_VELOCITY, entity));

    /// <summary>The four vectors of an entity's matrix in one call, so that they belong together.</summary>
    public static Pose EntityPose(int entity)
    {
        using var forward = new OutputArgument();
        using var right = new OutputArgument();
        using var up = new OutputArgument();
        using var position = new OutputArgument();
        Call(Hash.GET_ENTITY_MATRIX, entity, forward, right, up, position);
        return new Pose(Vector(position), Axes.FromVectors(Vector(right), Vector(forward), Vector(up)));
    }

    /// <summary>The vehicle that a ped sits in, or 0.</summary>
    public static int VehicleOf(int ped) =>
        Call<bool>(Hash.IS_PED_IN_ANY_VEHICLE, ped, false) ? Call<int>(Hash.GET_VEHICLE_PED_IS_IN, ped, false) : 0;

    /// <summary>Deletes an entity by the native for its kind; the game deletes only what belongs to a script.</summary>
    public static void Delete(int entity, Hash native)
    {
        Call(Hash.SET_ENTITY_AS_MISSION_ENTITY, entity, false, true);
        using var handle = new OutputArgument(entity);
        Call(native, handle);
    }

    // An array on purpose: the API's overloads by number of arguments are not the same in all versions.
    public static T Call<T>(Hash native, params InputArgument[] arguments) => Function.Call<T>(native, arguments);

    public static void Call(Hash native, params InputArgument[] arguments) => Function.Call(native, arguments);

    public static Vector3D Vector(OutputArgument written) => ToWorld(written.GetResult<Vector3>());

    public static Vector3D ToWorld(Vector3 vector) => new(vector.X, vector.Y, vector.Z);
}
