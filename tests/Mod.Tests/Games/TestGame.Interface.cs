using GTA.Native;

namespace Harvester.Mod.Tests.Games;

/// <summary>The natives about what is drawn, and about time.</summary>
internal sealed partial class TestGame
{
    private void AddInterfaceNatives()
    {
        _natives[Hash.SET_GAME_PAUSED] = a =>
        {
            IsPaused = (bool)a[0];
            return null;
        };
        _natives[Hash.GET_FRAME_COUNT] = _ => Frame;
    }
}
