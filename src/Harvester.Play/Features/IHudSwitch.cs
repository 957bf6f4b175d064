namespace Harvester.Play.Features;

/// <summary>Switches the game's own radar and head-up display, until they are switched again.</summary>
public interface IHudSwitch
{
    /// <summary>Whether the player's settings show radar and head-up display.</summary>
    bool IsWanted { get; }

    /// <summary>Whether radar or head-up display is shown now.</summary>
    bool IsShown { get; }

    /// <summary>Switches both.</summary>
    void Switch(bool isOn);
}
