using GTA.Native;
using Harvester.Capture.Ports;

namespace Harvester.Mod;

/// <summary>The two ways in which the game's world stands still while scripts run.</summary>
internal static class GameFreeze
{
    /// <summary>Stops the world in one of them, or lets it go on.</summary>
    public static void Set(FreezeMethod method, bool isFrozen)
    {
        const float standing = 0;
        const float running = 1;
        if (method == FreezeMethod.Paused)
        {
            Natives.Call(Hash.SET_GAME_PAUSED, isFrozen);
        }
        else
        {
            Natives.Call(Hash.SET_TIME_SCALE, isFrozen ? standing : running);
        }
    }
}
