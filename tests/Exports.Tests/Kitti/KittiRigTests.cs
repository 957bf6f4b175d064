using Harvester.Exports.Formats.Kitti;
using Harvester.Sessions.Rigs;

namespace Harvester.Exports.Tests.Kitti;

public sealed class KittiRigTests
{
    [Fact]
    public void Left_camera_of_a_pair_is_camera_2()
    {
        KittiRig rig = RigOf(Camera("right", 0.27), Camera("left", -0.27));

        Assert.True(rig.IsRectified);
        Assert.Equal((3, 2), (rig.SlotOf(0), rig.SlotOf(1)));
        Assert.Equal([null, null, 1, 0], Enumerable.Range(0, 4).Select(rig.ViewOf));
    }

    [Fact]
    public void Four_cameras_are_0_to_3_in_their_order()
    {
        KittiRig rig = RigOf(Camera("a", 0), Camera("b", 0.5), Camera("c", -0.1), Camera("d", 0.4));

        Assert.Equal([0, 1, 2, 3], Enumerable.Range(0, 4).Select(rig.SlotOf));
    }

    [Theory]
    [InlineData("\"yawDegrees\":1,")]
    [InlineData("\"lens\":{\"k1\":0.1},")]
    public void Cameras_that_differ_are_each_camera_2(string difference)
    {
        KittiRig rig = RigOf(Camera("left", -0.27), Camera("right", 0.27, difference));

        Assert.False(rig.IsRectified);
        Assert.Equal((2, 2), (rig.SlotOf(0), rig.SlotOf(1)));
    }

    [Fact]
    public void Three_cameras_do_not_belong_together() => Assert.False(RigOf(Camera("a", 0), Camera("b", 0.5), Camera("c", 1)).IsRectified);

    private static KittiRig RigOf(params string[] cameras) =>
        KittiRig.Of(RigParser.Parse($$"""{"name":"pair","cameras":[{{string.Join(',', cameras)}}]}"""));

    private static string Camera(string name, double right, string more = "") =>
        FormattableString.Invariant(
            $$"""{"name":"{{name}}","position":[{{right}},2,1],{{more}}"verticalFovDegrees":50,"width":80,"height":60}"""
        );
}
