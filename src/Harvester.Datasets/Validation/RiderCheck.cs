using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Datasets.Validation;

/// <summary>Checks whom and what the riders of a frame ride.</summary>
internal static class RiderCheck
{
    public static IEnumerable<string> Problems(ObjectLabel item, FrameLabel frame)
    {
        if (item.Vehicle is not { } id)
        {
            yield break;
        }

        if (item.Class != ObjectClass.Rider)
        {
            yield return "vehicle is given, but it is no rider.";
        }

        if (id is < 1 or > ushort.MaxValue || id == item.Id)
        {
            yield return $"vehicle is {id}; it must be another object's id.";
        }

        foreach (ObjectLabel vehicle in frame.Objects.Where(other => other.Id == id))
        {
            if (!VehicleClasses.HaveRiders(vehicle.Class))
            {
                yield return $"its vehicle, {id}, is no motorcycle or bicycle.";
            }
            else if (vehicle.HasRider == false)
            {
                yield return $"its vehicle, {id}, has hasRider false.";
            }
        }
    }
}
