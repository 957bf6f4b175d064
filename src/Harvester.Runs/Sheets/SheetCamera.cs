using Harvester.Runs.Faults;
using Harvester.Sessions.Imaging;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;

namespace Harvester.Runs.Sheets;

/// <summary>Takes the pictures of a contact sheet, each in a world of its own, with the camera of a harvest.</summary>
public static class SheetCamera
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
                        yield return new SheetTile(picture, SheetPlan.CaptionOf(place, new SheetMoment(weather, time, seconds)));
                    }
                }
            }
        }
    }

    private static SimulatedGame GameAt(SheetPlan plan, SheetPlace place, string weather, TimeSpan time)
    {
        try
        {
            return new SimulatedGame(
                new SimulationOptions
                {
                    Seed = plan.Seed,
                    Roads = plan.Roads,
                    Near = place.Position,
                    Props = plan.Props,
                    Weather = weather,
                    Detail = plan.Detail,
                    TimeOfDay = time,
                    IsTimeOfDayFixed = true,
                    VerticalFovDegrees = plan.FovDegrees,
                    WindowAspect = plan.Tile.Aspect,
                }
            );
        }
        catch (ArgumentException e)
        {
            throw new UsageException(place.Name.Length > 0 ? $"{place.Name}: {e.Message}" : e.Message);
        }
    }
}
