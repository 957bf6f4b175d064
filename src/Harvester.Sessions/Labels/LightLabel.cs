using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Labels;

/// <summary>The state of the head of a traffic light.</summary>
/// <param name="State">The lit lamp.</param>
/// <param name="Method">How the state was determined.</param>
/// <param name="LitFraction">Fraction of the head's box in the image whose pixels have the colour of the lit lamp, 0 to 1; null unless the
/// state was observed.</param>
public sealed record LightLabel(LightState State, LightMethod Method, double? LitFraction)
{
    /// <summary>The state is unknown.</summary>
    public static LightLabel Unknown { get; } = new(LightState.Unknown, LightMethod.Unknown, null);
}
