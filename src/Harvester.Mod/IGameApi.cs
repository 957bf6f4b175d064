using GTA.Native;
using Harvester.Capture.Ports;
using Harvester.Geometry;

namespace Harvester.Mod;

/// <summary>The one place where the mod calls the game: its natives, and the lists of the scripting API.</summary>
internal interface IGameApi
{
    /// <summary>Calls a native for its result.</summary>
    T Call<T>(Hash native, NativeArgument[] arguments);

    /// <summary>Calls a native for its effect.</summary>
    void Call(Hash native, NativeArgument[] arguments);

    /// <summary>The handles of the entities of a kind within a radius of a point.</summary>
    /// <param name="kind">What to list.</param>
    /// <param name="centre">The point, metres.</param>
    /// <param name="radius">The radius, metres.</param>
    /// <param name="models">Hashes of the models to list; none for all.</param>
    int[] Nearby(EntityKind kind, Vector3D centre, double radius, IReadOnlyList<int> models);
}
