using GTA.Native;
using Harvester.Capture.Ports;

namespace Harvester.Mod;

/// <summary>The two methods by which the game's world is frozen while scripts run.</summary>
internal static class GameFreeze
{
    /// <summary>Freezes or resumes the world by one of them.</summary>
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
