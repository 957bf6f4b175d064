using Harvester.Capture.Labelling;

namespace Harvester.Capture.Tests.Labelling;

public sealed class PlaceSequenceTests
{
    [Theory]
    [InlineData(100, 10)]
    [InlineData(7, 3)]
    [InlineData(1_000_000, 7)]
    [InlineData(5, 5)]
    [InlineData(1, 1)]
    public void Frames_are_divided_evenly_in_order(int frames, int places)
    {
        PlaceSequence sequence = new(frames, places);

        int[] placeOf = [.. Enumerable.Range(0, frames).Select(sequence.PlaceOf)];

        int[] sizes = [.. placeOf.GroupBy(place => place).Select(group => group.Count())];
        Assert.Equal(places, sizes.Length);
        Assert.InRange(sizes.Max() - sizes.Min(), 0, 1);
        Assert.Equal(placeOf.Order(), placeOf);
        Assert.All(Enumerable.Range(0, places), place => Assert.Equal(Array.IndexOf(placeOf, place), sequence.FirstFrameOf(place)));
    }

    [Theory]
    [InlineData(3, 4)]
    [InlineData(3, 0)]
    [InlineData(0, 1)]
    public void More_places_than_frames_are_refused(int frames, int places) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => new PlaceSequence(frames, places));
}
