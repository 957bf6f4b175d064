using GTA.Hosting;
using GTA.Math;

namespace GTA;

/// <summary>What is in the game's world.</summary>
public static class World
{
    /// <summary>The vehicles near a point.</summary>
    public static Vehicle[] GetNearbyVehicles(Vector3 position, float radius, params Model[] models) =>
        Near(PoolKind.Vehicles, position, radius, models, handle => new Vehicle(handle));

    /// <summary>The peds near a point.</summary>
    public static Ped[] GetNearbyPeds(Vector3 position, float radius, params Model[] models) =>
        Near(PoolKind.Peds, position, radius, models, handle => new Ped(handle));

    /// <summary>The props near a point.</summary>
    public static Prop[] GetNearbyProps(Vector3 position, float radius, params Model[] models) =>
        Near(PoolKind.Props, position, radius, models, handle => new Prop(handle));

    private static T[] Near<T>(PoolKind pool, Vector3 position, float radius, Model[] models, Converter<int, T> make)
    {
        ScriptThread.Require("a list of nearby entities");
        return Array.ConvertAll(GameHost.Current.HandlesNear(pool, position, radius, Array.ConvertAll(models, model => model.Hash)), make);
    }
}
