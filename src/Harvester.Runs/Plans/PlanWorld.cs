using System.Globalization;
using Harvester.Datasets.Roads;
using Harvester.Driving.Controllers;
using Harvester.Geometry;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;
using Harvester.Runs.Faults;
using Harvester.Runs.Harvesting;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Files;
using Harvester.Sessions.Plans;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Roads;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;
using Harvester.Simulation.Game;
using Harvester.Simulation.Models;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;
using Harvester.Simulation.World;

namespace Harvester.Runs.Plans;

/// <summary>The simulated world in which a plan runs, and the plan's places in it.</summary>
/// <param name="Roads">File of the road network; null for a town generated from the plan's seed.</param>
/// <param name="Detail">How much of the light the pictures show.</param>
public sealed record PlanWorld(string? Roads, Detail Detail)
{
    /// <summary>Table of the paint measured on the roads; null for none.</summary>
    public string? Paint { get; init; }

    /// <summary>Distance of the lane's middle from a sign beside the road, to the left of the car that comes to it, metres.</summary>
    private const double LeftOfSpace = 4;

    private const double WholeWorld = 100_000;

    /// <summary>
    /// What tells the world from others, as a file: digests of the roads and of the table of paint, if there is one, and the detail.
    /// </summary>
    /// <param name="plan">The plan.</param>
    /// <exception cref="DatasetFormatException">The roads or the table cannot be read, or the table is of other roads.</exception>
    /// <exception cref="IOException">The roads or the table cannot be read.</exception>
    public string ToJson(Plan plan)
    {
        ArgumentNullException.ThrowIfNull(plan);
        RoadNetwork? imported = Roads is null ? null : RoadImporter.Import(Roads).Network;
        string roads = imported is null ? "null" : DigestOf(text => RoadCsvWriter.Write(imported, text));
        string paint = "";
        if (Paint is not null)
        {
            PaintTable table = PaintFile.Read(Paint, imported ?? TownBuilder.Build(plan.Seed));
            paint = $",\"paint\":{DigestOf(text => PaintCsvWriter.Write(table, text))}";
        }

        return $"{{\"roads\":{roads},\"detail\":\"{JsonName.Of(Detail)}\"{paint}}}\n";
    }

    /// <summary>The places of a plan with those that it leaves open chosen, in its order.</summary>
    /// <exception cref="UsageException">The roads have too few places or no such space, or two places get the same name.</exception>
    public IReadOnlyList<PlanPlace> PlacesOf(Plan plan)
    {
        Lazy<RoadNetwork> network = new(() => Roads is null ? TownBuilder.Build(plan.Seed) : RoadImporter.Import(Roads).Network);
        Lazy<List<(EntityState Entity, ModelFace Face)>> spaces = new(() => SpacesOf(plan));
        PlanPlace[] places =
        [
            .. plan.Places.SelectMany(place =>
                place.Spread is { } count ? Spread(place, count, network.Value, plan.Seed)
                : place.Space is not null ? [Before(place, spaces.Value)]
                : [place]
            ),
        ];
        string? twice = places
            .GroupBy(place => place.Name, StringComparer.OrdinalIgnoreCase)
            .FirstOrDefault(group => group.Count() > 1)
            ?.Key;
        return twice is null
            ? places
            : throw new UsageException($"Two places are called '{twice}' once the spread ones are chosen. Rename one in the plan.");
    }

    private static string DigestOf(Action<TextWriter> write)
    {
        using var text = new StringWriter(CultureInfo.InvariantCulture);
        write(text);
        return $"\"{FileDigest.Of(text.ToString()).Sha256}\"";
    }

    /// <summary>Several places all over the roads, chosen as for harvest --places.</summary>
    private static IEnumerable<PlanPlace> Spread(PlanPlace place, int count, RoadNetwork network, int seed)
    {
        string digits = new('0', count.ToString(CultureInfo.InvariantCulture).Length);
        return SpreadPlaces
            .Of(network, count, seed)
            .Select(
                (point, index) =>
                    place with
                    {
                        Name = $"{place.Name}-{(index + 1).ToString(digits, CultureInfo.InvariantCulture)}",
                        Point = point,
                        Spread = null,
                    }
            );
    }

    /// <summary>A place before the first space of a name, with the car on its way to it.</summary>
    private static PlanPlace Before(PlanPlace place, List<(EntityState Entity, ModelFace Face)> spaces)
    {
        string name = place.Space!;
        (EntityState entity, ModelFace face) = spaces.FirstOrDefault(each => IsCalled(each.Face, name));
        if (entity is null)
        {
            string[] known = [.. spaces.Select(each => each.Face.Name).Distinct().Order(StringComparer.Ordinal)];
            throw new UsageException(
                $"No space '{name}' of the place '{place.Name}' is in this world, which has "
                    + (known.Length == 0 ? "none." : $"{string.Join(", ", known)}.")
            );
        }

        Vector3D towards = face.DirectionAt(entity.Pose);
        var ahead = new Vector2D(-towards.X, -towards.Y);
        Vector2D left = new(-ahead.Y, ahead.X);
        var at = new Vector2D(entity.Pose.Position.X, entity.Pose.Position.Y);
        return place with
        {
            Point = at - (ahead * place.MetresBefore) + (left * LeftOfSpace),
            HeadingDegrees = PathFollower.HeadingOf(ahead),
            Space = null,
        };
    }

    private static bool IsCalled(ModelFace face, string name) =>
        new[] { face.Name, face.MutcdCode, face.Model }.Contains(name, StringComparer.OrdinalIgnoreCase);

    private List<(EntityState Entity, ModelFace Face)> SpacesOf(Plan plan)
    {
        try
        {
            var game = new SimulatedGame(
                new SimulationOptions
                {
                    Seed = plan.Seed,
                    Roads = Roads is null ? null : RoadImporter.Import(Roads).Network,
                    TrafficDensity = 0,
                    PedestrianDensity = 0,
                }
            );
            return
            [
                .. game
                    .Ports.World.ReadEntities(Vector3D.Zero, WholeWorld)
                    .SelectMany(entity => ModelFaces.Table.Of(entity.Model).Select(face => (entity, face))),
            ];
        }
        catch (ArgumentException e)
        {
            throw new UsageException(e.Message);
        }
    }
}
