using GTA;
using GTA.Math;
using GTA.Native;
using Harvester.Capture.Ports;
using Harvester.Geometry;

namespace Harvester.Mod;

/// <summary>The game behind ScriptHookVDotNet.</summary>
internal sealed class ScriptApi : IGameApi
{
    /// <inheritdoc/>
    public T Call<T>(Hash native, NativeArgument[] arguments) => Function.Call<T>(native, NativeArgument.ForApi(arguments));

    /// <inheritdoc/>
    public void Call(Hash native, NativeArgument[] arguments) => Function.Call(native, NativeArgument.ForApi(arguments));

    /// <inheritdoc/>
    public int[] Nearby(EntityKind kind, Vector3D centre, double radius, IReadOnlyList<int> models)
    {
        var place = new Vector3((float)centre.X, (float)centre.Y, (float)centre.Z);
        Model[] wanted = [.. models.Select(hash => new Model(hash))];
        IEnumerable<Entity> near = kind switch
        {
            EntityKind.Vehicle => World.GetNearbyVehicles(place, (float)radius, wanted),
            EntityKind.Ped => World.GetNearbyPeds(place, (float)radius, wanted),
            _ => World.GetNearbyProps(place, (float)radius, wanted),
        };
        return [.. near.Select(entity => entity.Handle)];
    }
}
