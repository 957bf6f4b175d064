using Harvester.Geometry.Cameras;

namespace Harvester.Sessions.Text;

/// <summary>A lens in a settings file: the section [Lens].</summary>
public static class LensSettings
{
    /// <summary>Name of the section.</summary>
    public const string Section = "Lens";

    private const string FocalScale = "FocalScale";
    private const string CentreOffsetX = "CentreOffsetX";
    private const string CentreOffsetY = "CentreOffsetY";
    private const string K1 = "K1";
    private const string K2 = "K2";

    /// <summary>The values of a lens by their names.</summary>
    public static IReadOnlyList<KeyValuePair<string, double>> ValuesOf(Lens lens) =>
        [
            new(FocalScale, lens.FocalScale),
            new(CentreOffsetX, lens.CentreOffsetX),
            new(CentreOffsetY, lens.CentreOffsetY),
            new(K1, lens.K1),
            new(K2, lens.K2),
        ];

    /// <summary>The lens of a settings file; missing and invalid values are those of a pinhole camera.</summary>
    /// <exception cref="ArgumentNullException"><paramref name="ini"/> is null.</exception>
    public static Lens Read(IniFile ini)
    {
        if (ini is null)
        {
            throw new ArgumentNullException(nameof(ini));
        }

        const double maxShift = 0.5;
        return new Lens(
            ini.Number(Section, FocalScale, 1, 0.5, 2),
            ini.Number(Section, CentreOffsetX, 0, -maxShift, maxShift),
            ini.Number(Section, CentreOffsetY, 0, -maxShift, maxShift),
            ini.Number(Section, K1, 0, -1, 1),
            ini.Number(Section, K2, 0, -1, 1)
        );
    }
}
