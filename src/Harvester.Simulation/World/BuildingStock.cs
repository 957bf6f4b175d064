using System;
using System.Collections.Generic;
using System.Globalization;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Models;

namespace Harvester.Simulation.World;

/// <summary>The set of buildings of a town.</summary>
internal static class BuildingStock
{
    private const int OfEachStyle = 5;

    public static List<Model> Make(int seed)
    {
        Random random = new(seed);
        List<Model> stock = [];
        foreach (BuildingStyle style in Enum.GetValues<BuildingStyle>())
        {
            (double width, double depth, double height, double spread) = style switch
            {
                BuildingStyle.House => (12.0, 10.0, 6.0, 0.2),
                BuildingStyle.Block => (20.0, 14.0, 15.0, 0.35),
                BuildingStyle.Tower => (24.0, 20.0, 48.0, 0.4),
                _ => (26.0, 20.0, 8.0, 0.2),
            };
            for (int i = 0; i < OfEachStyle; i++)
            {
                string name = string.Create(CultureInfo.InvariantCulture, $"building_{style}_{i}").ToLowerInvariant();
                stock.Add(Model.Of(name, ObjectClass.Other,
                    [BuildingModels.Create(style, Vary(width), Vary(depth), Vary(height), random.Next())]));
            }

            double Vary(double size) => size * (1 + (spread * ((2 * random.NextDouble()) - 1)));
        }

        return stock;
    }
}
