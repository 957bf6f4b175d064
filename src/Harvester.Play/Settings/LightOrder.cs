namespace Harvester.Play.Settings;

/// <summary>The meaning of the game's numbers 0, 1 and 2 for the states of a traffic light. Sources contradict each other.</summary>
public enum LightOrder
{
    /// <summary>0 is green, 1 red, 2 amber.</summary>
    GreenRedAmber,

    /// <summary>0 is red, 1 amber, 2 green.</summary>
    RedAmberGreen,
}
