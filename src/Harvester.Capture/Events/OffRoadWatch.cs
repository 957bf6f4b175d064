using Harvester.Sessions.Events;

namespace Harvester.Capture.Events;

/// <summary>Finds vehicles that drive beside the road: their middle lies beyond the shoulder of every lane.</summary>
internal sealed class OffRoadWatch : IEventWatch
{
    /// <inheritdoc/>
    public void Observe(SceneReading reading, EventBook book)
    {
        foreach (RoadUser user in reading.Roads is null ? [] : reading.Driven)
        {
            if (user.IsNew || user.Now.Speed < EventRules.MinOffRoadSpeed || reading.Roads!.SpotsOf(user).Count > 0)
            {
                continue;
            }

            double? distance = reading.Roads.FromRoad(user);
            OpenEvent open = book.FindOrBegin(EventKind.OffRoad, reading.Seconds, user);
            if (open.Hold(reading.Seconds, -(distance ?? EventRules.BesideMetres)))
            {
                open.Measures = [new(EventMeasures.FromRoad, distance), new(EventMeasures.Speed, user.Now.Speed)];
            }
        }
    }
}
