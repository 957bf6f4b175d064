using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Datasets.Validation;

/// <summary>Checks the fields of objects that are parts of others.</summary>
internal static class FaceCheck
{
    public static IEnumerable<string> Problems(ObjectLabel item)
    {
        if (item.Face is null != item.Parent is null)
        {
            yield return "parent and space must be given together: a part has both, any other object neither.";
        }

        if (item.Parent is { } parent && (parent is < 1 or > ushort.MaxValue || parent == item.Id))
        {
            yield return $"parent is {parent}; it must be another object's id.";
        }

        if (item.Face is not { } face)
        {
            yield break;
        }

        if (face.FacingAngleDegrees is < 0 or > 180)
        {
            yield return FormattableString.Invariant($"facingAngleDegrees is {face.FacingAngleDegrees}; it must be 0 to 180.");
        }

        if (face.Light is null != (item.Class != ObjectClass.TrafficLight))
        {
            yield return "light must be given for a trafficLight, and only for it.";
        }

        if (face.Light is { } light)
        {
            if (light.LitFraction is < 0 or > 1)
            {
                yield return FormattableString.Invariant($"litFraction is {light.LitFraction}; it must be 0 to 1.");
            }

            if (light.Method == LightMethod.Unknown != (light.State == LightState.Unknown))
            {
                yield return $"light.state is {JsonName.Of(light.State)}, but light.method is {JsonName.Of(light.Method)}; if one is "
                    + "unknown, both must be.";
            }
        }
    }
}
