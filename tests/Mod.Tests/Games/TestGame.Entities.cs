using GTA.Native;
using Harvester.Geometry;

namespace Harvester.Mod.Tests.Games;

/// <summary>The natives about entities.</summary>
internal sealed partial class TestGame
{
    private void AddEntityNatives()
    {
        _natives[Hash.PLAYER_PED_ID] = _ => Player;
        _natives[Hash.DOES_ENTITY_EXIST] = a => Entities.ContainsKey((int)a[0]);
        _natives[Hash.GET_ENTITY_MODEL] = a => Entities[(int)a[0]].Model;
        _natives[Hash.GET_ENTITY_VELOCITY] = a => ToGame(Entities[(int)a[0]].Velocity);
        _natives[Hash.GET_ENTITY_HEADING] = a => (float)Angles.HeadingDegrees(Entities[(int)a[0]].Pose.Axes.Forward);
        _natives[Hash.GET_OFFSET_FROM_ENTITY_IN_WORLD_COORDS] = a => ToGame(Entities[(int)a[0]].Pose.ToWorld(ToWorld(a[1], a[2], a[3])));
        _natives[Hash.GET_ENTITY_MATRIX] = a =>
        {
            Pose pose = Entities[(int)a[0]].Pose;
            Write(a[1], ToGame(pose.Axes.Forward));
            Write(a[2], ToGame(pose.Axes.Right));
            Write(a[3], ToGame(pose.Axes.Up));
            Write(a[4], ToGame(pose.Position));
            return null;
        };
    }

    private static void Write(object place, object value) => ((OutputArgument)place).Value = value;
}
