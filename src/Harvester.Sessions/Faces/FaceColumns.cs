namespace Harvester.Sessions.Faces;

/// <summary>The columns of spaces_of_interest.csv, in their order; data/README.md says what each holds.</summary>
internal static class FaceColumns
{
    public const string Header = "model,hash,class,name,mutcd,face,fulX,fulY,fulZ,blrX,blrY,blrZ,facing,provenance,source";

    /// <summary>Where fulX stands, the first of the six columns of the corners.</summary>
    public const int FirstCorner = 6;

    public static readonly string[] Names = Header.Split(',');
}
