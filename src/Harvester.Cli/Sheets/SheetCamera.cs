using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Threading;
using Harvester.Cli.Terminals;
using Harvester.Sessions.Imaging;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;

namespace Harvester.Cli.Sheets;

/// <summary>Takes the pictures of a contact sheet, each in a world of its own, with the camera of a harvest.</summary>
internal static class SheetCamera
{
    private const double TickSeconds = 1.0 / 60;

    /// <summary>The tiles, place by place.</summary>
    /// <param name="plan">The sheet.</param>
    /// <param name="cancellation">Stops between two ticks.</param>
    /// <exception cref="UsageException">There is no road near a place.</exception>
    /// <exception cref="OperationCanceledException">It was stopped.</exception>
    public static IEnumerable<SheetTile> Take(SheetPlan plan, CancellationToken cancellation)
    {
        foreach (SheetPlace place in plan.Places)
        {
            foreach (string weather in plan.Weathers)
            {
                foreach (TimeSpan time in plan.Times)
                {
                    SimulatedGame game = GameAt(plan, place, weather, time);
                    long ticks = 0;
                    foreach (double seconds in plan.Seconds)
                    {
                        for (; ticks * TickSeconds < seconds; ticks++)
                        {
                            cancellation.ThrowIfCancellationRequested();
                            game.Tick(TickSeconds);
                        }

                        var picture = new PixelBuffer(plan.Tile);
                        game.Ports.Screen.Grab(picture);
                        yield return new SheetTile(picture, CaptionOf(place, new SheetMoment(weather, time, seconds)));
                    }
                }
            }
        }
    }

    private static SimulatedGame GameAt(SheetPlan plan, SheetPlace place, string weather, TimeSpan time)
    {
        try
        {
            return new SimulatedGame(new SimulationOptions
            {
                Seed = plan.Seed,
                Roads = plan.Roads,
                Near = place.Position,
                Props = plan.Props,
                Weather = weather,
                TimeOfDay = time,
                IsTimeOfDayFixed = true,
                VerticalFovDegrees = plan.FovDegrees,
                WindowAspect = plan.Tile.Aspect,
            });
        }
        catch (ArgumentException e)
        {
            throw new UsageException(place.Name.Length > 0 ? $"{place.Name}: {e.Message}" : e.Message);
        }
    }

    private static string CaptionOf(SheetPlace place, SheetMoment moment)
    {
        string at = place.Position is { } position
            ? string.Create(CultureInfo.InvariantCulture, $"{position.X:0.#},{position.Y:0.#}") : "";
        string when = string.Create(CultureInfo.InvariantCulture, $"{moment.Weather} {moment.TimeOfDay:hh\\:mm} {moment.Seconds:0.##} s");
        return string.Join("  ", new[] { place.Name, at, when }.Where(part => part.Length > 0));
    }
}
