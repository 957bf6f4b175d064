using System.Globalization;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Models;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.World;

/// <summary>The buildings of a world, by the zones in which they stand.</summary>
internal sealed class BuildingStock
{
    private const int OfEachStyle = 5;

    private readonly Dictionary<Zone, Model[]> _byZone;

    public BuildingStock(int seed)
    {
        Random random = new(seed);
        Dictionary<BuildingStyle, List<Model>> byStyle = [];
        foreach (BuildingStyle style in Enum.GetValues<BuildingStyle>())
        {
            (double width, double depth, double height, double spread) = style switch
            {
                BuildingStyle.House => (12.0, 10.0, 6.0, 0.2),
                BuildingStyle.Block => (20.0, 14.0, 15.0, 0.35),
                BuildingStyle.Tower => (24.0, 20.0, 48.0, 0.4),
                _ => (26.0, 20.0, 8.0, 0.2),
            };
            byStyle[style] = [];
            for (int i = 0; i < OfEachStyle; i++)
            {
                string name = string.Create(CultureInfo.InvariantCulture, $"building_{style}_{i}").ToLowerInvariant();
                byStyle[style]
                    .Add(
                        Model.Of(
                            name,
                            ObjectClass.Other,
                            [BuildingModels.Create(style, Vary(width), Vary(depth), Vary(height), random.Next())]
                        )
                    );
            }

            double Vary(double size) => size * (1 + (spread * ((2 * random.NextDouble()) - 1)));
        }

        _byZone = Enum.GetValues<Zone>().ToDictionary(zone => zone, zone => StylesOf(zone).SelectMany(style => byStyle[style]).ToArray());
    }

    /// <summary>The buildings of a zone; those that are frequent there are listed more than once.</summary>
    public IReadOnlyList<Model> In(Zone zone) => _byZone[zone];

    private static BuildingStyle[] StylesOf(Zone zone) =>
        zone switch
        {
            Zone.Centre => [BuildingStyle.Block, BuildingStyle.Tower, BuildingStyle.Tower],
            Zone.Town => [BuildingStyle.House, BuildingStyle.Block, BuildingStyle.Block, BuildingStyle.Warehouse],
            Zone.Suburb => [BuildingStyle.House, BuildingStyle.House, BuildingStyle.House, BuildingStyle.Warehouse],
            _ => [BuildingStyle.House, BuildingStyle.Warehouse],
        };
}
