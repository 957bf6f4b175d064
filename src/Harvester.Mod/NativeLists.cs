using GTA.Native;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Visibility;
using Harvester.Play.Features;
using Harvester.Sessions.Scenes;

namespace Harvester.Mod;

/// <summary>
/// Lists the entities near the camera by the game's natives, for when the API's lists fail: those known to the people around, the closest
/// prop of each model, and what rays through the image hit. What was found is remembered as long as it exists, so the list becomes more
/// complete during the drive. While the game's time stands still nothing new is searched: a frozen frame has the same entities each time it
/// is read.
/// </summary>
/// <param name="time">The game's time.</param>
/// <param name="rays">The game's rays.</param>
internal sealed class NativeLists(GameTime time, GameRays rays)
{
    private const double SecondsBetweenSearches = 0.2;

    /// <summary>Maximum number of people who are asked for what is near them: the player first, then those whom others named.</summary>
    private const int MaxPeopleAsked = 24;

    /// <summary>Capacity of one answer. The game itself names fewer.</summary>
    private const int MaxNamed = 64;

    private const int RayColumns = 16;
    private const int RayRows = 9;

    /// <summary>
    /// Distances ahead of the camera at which props are searched, metres: at each, the closest one of a model is returned.
    /// </summary>
    private static readonly double[] MetresAhead = [0, 30, 60, 90];

    private readonly Dictionary<int, EntityKind> _found = [];
    private double _peopleAskedAt = double.NegativeInfinity;
    private double _propsFoundAt = double.NegativeInfinity;
    private double _raysCastAt = double.NegativeInfinity;

    /// <summary>The entities of a kind within a radius of a point.</summary>
    /// <param name="kind">What to list.</param>
    /// <param name="centre">The point, metres.</param>
    /// <param name="radius">The radius, metres.</param>
    /// <param name="models">Models of props to search for, by hash.</param>
    public IReadOnlyList<int> Near(EntityKind kind, Vector3D centre, double radius, IReadOnlyList<int> models)
    {
        if (kind != EntityKind.Prop && IsDue(ref _peopleAskedAt))
        {
            AskPeople();
        }
        else if (kind == EntityKind.Prop && IsDue(ref _propsFoundAt))
        {
            FindProps(RenderedCamera.Read().Pose, radius, models);
        }

        if (IsDue(ref _raysCastAt))
        {
            CastRays(RenderedCamera.Read(), radius);
        }

        foreach (int gone in _found.Keys.Where(entity => !Natives.EntityExists(entity)).ToArray())
        {
            _found.Remove(gone);
        }

        return [.. _found.Where(entity => entity.Value == kind && IsNear(entity.Key, centre, radius)).Select(entity => entity.Key)];
    }

    /// <summary>
    /// Whether the player knows of a vehicle or person near a point, or a prop of a model exists: enough to doubt an empty list.
    /// </summary>
    public static bool HasAny(EntityKind kind, Vector3D centre, double radius, int model)
    {
        int[] named = kind switch
        {
            EntityKind.Vehicle => VehiclesNear(Natives.PlayerPed()),
            EntityKind.Ped => PedsNear(Natives.PlayerPed()),
            _ => [ClosestProp(centre, radius, model)],
        };
        return named.Any(entity => entity != 0 && IsNear(entity, centre, radius));
    }

    private bool IsDue(ref double doneAt)
    {
        bool isDue = Math.Abs(time.Seconds - doneAt) >= SecondsBetweenSearches;
        doneAt = isDue ? time.Seconds : doneAt;
        return isDue;
    }

    private void AskPeople()
    {
        var waiting = new Queue<int>([Natives.PlayerPed()]);
        var known = new HashSet<int>(waiting);
        for (int asked = 0; waiting.Count > 0 && asked < MaxPeopleAsked; asked++)
        {
            int ped = waiting.Dequeue();
            foreach (int vehicle in VehiclesNear(ped))
            {
                _found[vehicle] = EntityKind.Vehicle;
            }

            foreach (int other in PedsNear(ped).Where(known.Add))
            {
                _found[other] = EntityKind.Ped;
                waiting.Enqueue(other);
            }
        }
    }

    private void FindProps(Pose camera, double radius, IReadOnlyList<int> models)
    {
        foreach (double ahead in MetresAhead.Where(metres => metres <= radius))
        {
            Vector3D place = camera.ToWorld(new Vector3D(0, ahead, 0));
            foreach (int prop in models.Select(model => ClosestProp(place, radius, model)).Where(prop => prop != 0))
            {
                _found[prop] = EntityKind.Prop;
            }
        }
    }

    private void CastRays(CameraState camera, double reach)
    {
        double up = Math.Tan(Angles.ToRadians(camera.VerticalFovDegrees) / 2);
        double right = up * camera.WindowAspect;
        for (int row = 0; row < RayRows; row++)
        {
            for (int column = 0; column < RayColumns; column++)
            {
                var local = new Vector3D(right * Middle(column, RayColumns), 1, -up * Middle(row, RayRows));
                if (
                    rays.Cast(new Ray(camera.Pose.Position, camera.Pose.Axes.ToWorld(local)), reach, RayHit.World)
                        is { Entity: not RayHit.World } hit
                    && KindOf(hit.Entity) is { } kind
                )
                {
                    _found[hit.Entity] = kind;
                }
            }
        }
    }

    /// <summary>The middle of a cell of a row of cells that reaches from -1 to 1.</summary>
    private static double Middle(int cell, int cells) => ((2 * cell) + 1.0 - cells) / cells;

    private static EntityKind? KindOf(int entity) =>
        Natives.Call<int>(Hash.GET_ENTITY_TYPE, entity) switch
        {
            1 => EntityKind.Ped,
            2 => EntityKind.Vehicle,
            3 => EntityKind.Prop,
            _ => null,
        };

    private static bool IsNear(int entity, Vector3D centre, double radius) => (Natives.EntityPosition(entity) - centre).Length < radius;

    private static int ClosestProp(Vector3D place, double radius, int model) =>
        Natives.Call<int>(
            Hash.GET_CLOSEST_OBJECT_OF_TYPE,
            (float)place.X,
            (float)place.Y,
            (float)place.Z,
            (float)radius,
            model,
            false,
            false,
            false
        );

    private static int[] VehiclesNear(int ped)
    {
        using var list = NativeOutput.Holding(MaxNamed, 1 + MaxNamed);
        return Named(list, Natives.Call<int>(Hash.GET_PED_NEARBY_VEHICLES, ped, list));
    }

    private static int[] PedsNear(int ped)
    {
        const int nobody = -1;
        using var list = NativeOutput.Holding(MaxNamed, 1 + MaxNamed);
        return Named(list, Natives.Call<int>(Hash.GET_PED_NEARBY_PEDS, ped, list, nobody));
    }

    /// <summary>The first slot of a list is its capacity, each further one a handle.</summary>
    private static int[] Named(NativeOutput list, int count) =>
        [.. Enumerable.Range(1, Math.Min(count, MaxNamed)).Select(list.IntegerAt).Where(Natives.EntityExists)];
}
