using Harvester.Exports.Formats.OpenLaneV2;
using Harvester.Geometry;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests.OpenLaneV2;

/// <summary>
/// Categories and attributes of OpenLane-V2: 1 a light with 0 unknown, 1 red, 2 green, 3 yellow; 2 a sign with 7 no left turn, 8 no right
/// turn, 10 no U-turn.
/// </summary>
[Collection(SimulatedSession.Collection)]
public sealed class TrafficElementTests(SimulatedSession simulated)
{
    private static readonly string[] Lanes = ["1-2/f0", "1-2/f1"];

    [Theory]
    [InlineData(LightState.Red, 1)]
    [InlineData(LightState.Green, 2)]
    [InlineData(LightState.Amber, 3)]
    [InlineData(LightState.Unknown, 0)]
    public void Head_of_a_light_has_its_colour(LightState state, int attribute)
    {
        ObjectLabel head = Head(state, facingAngle: 20);

        TrafficElement element = Assert.Single(ElementsOf(head));

        Assert.Equal((7, 1, attribute, head.Box2D), (element.Id, element.Category, element.Attribute, element.Box));
        Assert.Equal(Lanes, element.Lanes);
    }

    [Theory]
    [InlineData("R3-2", 7)]
    [InlineData("R3-1", 8)]
    [InlineData("R3-4", 10)]
    public void Signs_about_turns_have_the_benchmarks_number(string code, int attribute)
    {
        TrafficElement element = Assert.Single(ElementsOf(Sign(code, facingAngle: 20)));

        Assert.Equal((2, attribute), (element.Category, element.Attribute));
    }

    [Fact]
    public void Other_signs_are_no_elements() => Assert.Empty(ElementsOf(Sign("R1-1", facingAngle: 20), Sign(null, facingAngle: 20)));

    [Fact]
    public void Heads_and_signs_seen_from_behind_are_no_elements() =>
        Assert.Empty(ElementsOf(Head(LightState.Red, facingAngle: 120), Sign("R3-1", facingAngle: 120)));

    [Fact]
    public void Light_with_known_heads_is_not_an_element_beside_them()
    {
        ObjectLabel head = Head(LightState.Red, facingAngle: 20);

        Assert.Equal([7], ElementsOf(Post(knownParts: 2), head).Select(element => element.Id));
    }

    [Fact]
    public void Light_without_known_heads_is_an_element_of_unknown_state()
    {
        TrafficElement element = Assert.Single(ElementsOf(Post(knownParts: null)));

        Assert.Equal((9, 1, 0), (element.Id, element.Category, element.Attribute));
    }

    [Fact]
    public void Light_whose_visibility_is_unknown_is_no_element() =>
        Assert.Empty(ElementsOf(Head(LightState.Red, facingAngle: 20) with { OcclusionMethod = OcclusionMethod.None }));

    [Fact]
    public void Light_that_governs_no_lane_is_an_element_without_lanes() =>
        Assert.Empty(Assert.Single(ElementsOf(Head(LightState.Red, facingAngle: 20) with { GovernedLanes = null })).Lanes);

    private TrafficElement[] ElementsOf(params ObjectLabel[] objects)
    {
        FrameLabel frame = simulated.Open().ReadLabels().First();
        return [.. TrafficElement.Of(frame with { Objects = objects })];
    }

    private ObjectLabel Post(int? knownParts) => Light() with { Id = 9, KnownParts = knownParts };

    private ObjectLabel Head(LightState state, double facingAngle) =>
        Light() with
        {
            Id = 7,
            Parent = 9,
            Face = new FaceLabel(0, null, facingAngle, Provenance.Derived, new LightLabel(state, LightMethod.Observed, 0)),
        };

    private ObjectLabel Sign(string? code, double facingAngle) =>
        Light() with
        {
            Class = ObjectClass.Sign,
            Face = new FaceLabel(0, code, facingAngle, Provenance.Derived, null),
        };

    private ObjectLabel Light()
    {
        ObjectLabel any = simulated.Open().ReadLabels().SelectMany(frame => frame.Objects).First(label => label.Face is null);
        return any with
        {
            Class = ObjectClass.TrafficLight,
            Parent = null,
            KnownParts = null,
            Box2D = new Box2D(10, 20, 30, 50),
            OcclusionMethod = OcclusionMethod.Rays,
            OccludedFraction = 0,
            GovernedLanes = Lanes,
        };
    }
}
