using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Reading;

/// <summary>The props of signs and lights whose faces or heads are objects of their own.</summary>
internal static class Posts
{
    /// <summary>Whether a label is such a prop.</summary>
    /// <param name="label">The label.</param>
    /// <param name="frame">Its frame.</param>
    public static bool Has(ObjectLabel label, FrameLabel frame) =>
        label.Parent is null
        && label.Class is ObjectClass.Sign or ObjectClass.TrafficLight
        && (label.KnownParts ?? frame.Objects.Count(other => other.Parent == label.Id)) > 0;
}
