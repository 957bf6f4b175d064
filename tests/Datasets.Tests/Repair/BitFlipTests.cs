using Harvester.Datasets.Validation;
using Harvester.TestSupport;

namespace Harvester.Datasets.Tests.Repair;

/// <summary>Every single flipped bit in any file of a session is noticed.</summary>
public sealed class BitFlipTests(DamagedSession session) : IClassFixture<DamagedSession>
{
    private const int Seed = 20_261_123;

    public static TheoryData<string> Names { get; } =
    [
        "frames/00000001.png",
        "masks/00000001.png",
        "scenes/00000001.json",
        "scenes/roads.csv",
        "scenes/spaces.csv",
        "session.json",
        "labels.jsonl",
        "manifest.jsonl",
    ];

    [Fact]
    public void Undamaged_session_has_no_problems() => Assert.Empty(SessionValidator.Validate(session.Open()).Problems);

    [Theory]
    [MemberData(nameof(Names))]
    public void Validate_notices_flipped_bits(string name) => CheckNoticed(name, 4, isQuick: false);

    [Theory]
    [MemberData(nameof(Names))]
    public void Quick_validate_notices_flipped_bits(string name) => CheckNoticed(name, 4, isQuick: true);

    [Theory]
    [MemberData(nameof(Names))]
    [Trait("Category", "Heavy")]
    public void Validate_notices_every_flipped_bit(string name) => CheckNoticed(name, ProofSize.Of(inCi: 50, full: 200), isQuick: false);

    [Theory]
    [InlineData("frames/00000001.png")]
    [InlineData("masks/00000001.png")]
    [Trait("Category", "Heavy")]
    public void Pictures_without_manifest_are_checked_by_decoding(string name)
    {
        session.MakeOlder();
        Assert.True(SessionValidator.Validate(session.Open()).IsGood);

        CheckNoticed(name, 15, isQuick: false);
    }

    private void CheckNoticed(string name, int flips, bool isQuick)
    {
        var random = new Random(Seed);
        try
        {
            for (int i = 0; i < flips; i++)
            {
                int bit = random.Next(session.Bits(name));
                session.Flip(name, bit);
                Assert.False(SessionValidator.Validate(session.Open(), isQuick: isQuick).IsGood, $"{name}: bit {bit}");
                session.Flip(name, bit);
            }
        }
        finally
        {
            session.Restore();
        }
    }
}
