using GTA.Native;
using Harvester.Play.Features;

namespace Harvester.Mod;

/// <summary>Switches radar and head-up display by the game's natives.</summary>
internal sealed class GameHud : IHudSwitch
{
    /// <inheritdoc/>
    public bool IsWanted =>
        Natives.Call<bool>(Hash.IS_RADAR_PREFERENCE_SWITCHED_ON) | Natives.Call<bool>(Hash.IS_HUD_PREFERENCE_SWITCHED_ON);

    /// <inheritdoc/>
    public bool IsShown => !Natives.Call<bool>(Hash.IS_RADAR_HIDDEN) | !Natives.Call<bool>(Hash.IS_HUD_HIDDEN);

    /// <inheritdoc/>
    public void Switch(bool isOn)
    {
        Natives.Call(Hash.DISPLAY_RADAR, isOn);
        Natives.Call(Hash.DISPLAY_HUD, isOn);
    }
}
