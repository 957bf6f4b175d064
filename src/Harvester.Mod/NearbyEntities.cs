using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Play.Features;

namespace Harvester.Mod;

/// <summary>
/// The entities near a point, from the API's lists while these work. The API reads them from the game's memory; updates of the game have
/// broken single lists, which then throw or stay empty. From then on natives replace that list.
/// </summary>
/// <param name="build">Whether the installed API can read this game's memory.</param>
/// <param name="natives">Replace a list that fails.</param>
/// <param name="reading">Records which lists have failed.</param>
/// <param name="messages">Shows one message for each list.</param>
internal sealed class NearbyEntities(GameBuild build, NativeLists natives, ReadingRecord reading, PlayerMessages messages)
{
    private int _doubted;

    /// <summary>The models of props to list, by hash.</summary>
    public IReadOnlyList<int> PropModels { get; set; } = [];

    /// <summary>Whether the API, and not natives, lists the entities of a kind.</summary>
    public bool IsListedByApi(EntityKind kind) => build.ListProblem is null && reading.SourceOf(kind) == ListSource.Api;

    /// <summary>The vehicles within a radius of a point.</summary>
    public IReadOnlyList<int> Vehicles(Vector3D centre, double radius) => List(EntityKind.Vehicle, centre, radius, []);

    /// <summary>The people and animals within a radius of a point, including the player.</summary>
    public IReadOnlyList<int> Peds(Vector3D centre, double radius) => List(EntityKind.Ped, centre, radius, []);

    /// <summary>The props within a radius of a point that have one of <see cref="PropModels"/>.</summary>
    public IReadOnlyList<int> Props(Vector3D centre, double radius) =>
        PropModels.Count == 0 ? [] : List(EntityKind.Prop, centre, radius, PropModels);

    /// <summary>The props of any model within a radius of a point. Natives find only those that rays hit.</summary>
    public IReadOnlyList<int> AllProps(Vector3D centre, double radius) => List(EntityKind.Prop, centre, radius, []);

    private IReadOnlyList<int> List(EntityKind kind, Vector3D centre, double radius, IReadOnlyList<int> models)
    {
        if (build.ListProblem is { } problem && reading.SourceOf(kind) == ListSource.Api)
        {
            FallBack(problem, EntityKind.Vehicle, EntityKind.Ped, EntityKind.Prop);
        }

        if (reading.SourceOf(kind) == ListSource.Api)
        {
            string failure = $"ScriptHookVDotNet lists no {kind}s although there are some.";
            try
            {
                int[] listed = Natives.Game.Nearby(kind, centre, radius, models);
                if (listed.Length > 0 || !NativeLists.HasAny(kind, centre, radius, NextModel()))
                {
                    return listed;
                }
            }
            catch (Exception exception) when (exception is not (ThreadAbortException or InvalidOperationException))
            {
                // An invalid operation means a full pool of handles; natives need as many.
                failure = $"ScriptHookVDotNet cannot list {kind}s ({exception.Message}).";
            }

            FallBack(failure, kind);
        }

        return natives.Near(kind, centre, radius, PropModels);
    }

    /// <summary>Checks an empty list of props by one model at a time, which costs one native.</summary>
    private int NextModel() => PropModels.Count == 0 ? 0 : PropModels[_doubted++ % PropModels.Count];

    private void FallBack(string why, params EntityKind[] kinds)
    {
        foreach (EntityKind kind in kinds)
        {
            reading.ListByNatives(kind);
        }

        messages.Tell(
            $"{why} The game's natives are used instead; they list fewer entities, so distant objects may lack labels. "
                + "Look for an update of ScriptHookVDotNet."
        );
    }
}
